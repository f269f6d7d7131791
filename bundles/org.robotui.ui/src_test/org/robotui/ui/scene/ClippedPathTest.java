package org.robotui.ui.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.eclipse.swt.graphics.Path;
import org.eclipse.swt.graphics.PathData;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class ClippedPathTest {
  private static final float FAR = (float) ClippedPath.FAR;

  @Test
  void whatLiesNearIsLeftAsItIs() {
    assertArrayEquals(new float[]{1, 2, 30, 40, -5, 6}, line(1, 2, 30, 40, -5, 6).points);
    assertArrayEquals(new float[]{0, 0, 9, 0, 9, 9}, Arrays.copyOf(area(0, 0, 9, 0, 9, 9).points, 6));
  }

  @Test
  void aLineEndsWhereItLeaves() {
    assertArrayEquals(new float[]{0, 10, FAR, 10}, line(0, 10, 1e12, 10).points);
    assertArrayEquals(new float[]{-FAR, 10, FAR, 10}, line(Double.NEGATIVE_INFINITY, 10, 1e300, 10).points);
    assertEquals(0, line(1e6, 1e6, 2e6, 5e6).points.length, "never seen");
  }

  @Test
  void aLineThatComesBackIsTwoLines() {
    PathData seen = line(0, 0, 1e5, 0, 1e5, 100, 0, 100);
    assertArrayEquals(new float[]{0, 0, FAR, 0, FAR, 100, 0, 100}, seen.points);
    assertEquals(2, moves(seen));
  }

  @Test
  void cornersThatAreNoNumbersAreLeftOut() {
    assertArrayEquals(new float[]{0, 0, 5, 5}, line(0, 0, Double.NaN, 3, 5, 5).points);
    assertEquals(0, area(Double.NaN, 0, 0, Double.NaN).points.length);
  }

  @Test
  void anAreaKeepsWhatIsWithin() {
    PathData seen = area(-1e300, -1e300, 1e300, -1e300, 1e300, 1e300, -1e300, 1e300);
    assertTrue(seen.points.length / 2 >= 4);
    for (float at : seen.points) {
      assertEquals(FAR, Math.abs(at));
    }
    assertEquals(0, area(1e6, 0, 2e6, 0, 2e6, 1e6).points.length, "outside");
    assertTrue(area(0, 0, 1e9, 0, 0, 100).points.length / 2 >= 3);
  }

  @Test
  void circlesOfAnySizeHaveABound() {
    for (double radius : new double[]{0, 1e-300, 5, 1e5, 1e300, Double.POSITIVE_INFINITY, Double.NaN}) {
      Path path = Circles.ring(TestDisplay.get(), 100, 100, radius, 2);
      for (float at : path.getPathData().points) {
        assertTrue(Math.abs(at) <= FAR, radius + " reaches " + at);
      }
      path.dispose();
    }
  }

  private static long moves(PathData data) {
    long moves = 0;
    for (byte type : data.types) {
      moves += type == org.eclipse.swt.SWT.PATH_MOVE_TO ? 1 : 0;
    }
    return moves;
  }

  private static PathData line(double... xy) {
    return data(ClippedPath.line(TestDisplay.get(), xy));
  }

  private static PathData area(double... xy) {
    return data(ClippedPath.area(TestDisplay.get(), xy));
  }

  private static PathData data(Path path) {
    PathData data = path.getPathData();
    path.dispose();
    return data;
  }
}
