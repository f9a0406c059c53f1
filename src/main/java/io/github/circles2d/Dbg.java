package io.github.circles2d;
import io.github.circles2d.host.Batch;
public class Dbg { public static void p(){ System.out.println("colours mean "+(double)Batch.sumColours/Batch.sumTiles+" max "+Batch.maxColours+" depth mean "+(double)Batch.sumDepth/Batch.sumTiles+" max "+Batch.maxDepth+" tilings "+java.util.Arrays.toString(Batch.perTiling)); } }
