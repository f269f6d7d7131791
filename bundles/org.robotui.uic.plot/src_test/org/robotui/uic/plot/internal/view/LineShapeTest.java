package org.robotui.uic.plot.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.junit.jupiter.api.Test;

class LineShapeTest {
  private final LineShape shape = new LineShape();

  @ParameterizedTest
  @ValueSource(doubles = {0.02, 0.3, 5, 200})
  void whatIsLeftOutLiesOnTheLine(double roughness) {
    Random random = new Random(7);
    int count = 5000;
    float[] xs = new float[count];
    float[] ys = new float[count];
    for (int i = 1; i < count; i++) {
      xs[i] = xs[i - 1] + random.nextInt(4) / 3f;
      ys[i] = (float) (ys[i - 1] + random.nextGaussian() * roughness);
    }
    add(xs, ys);
    int at = 0;
    for (int i = 0; i < count; i++) {
      while (at + 2 < shape.size() && shape.x(at + 1) < xs[i]) {
        at++;
      }
      if (xs[i] > shape.x(at) && xs[i] < shape.x(at + 1)) {
        double share = (xs[i] - shape.x(at)) / (shape.x(at + 1) - shape.x(at));
        double line = shape.y(at) + share * (shape.y(at + 1) - shape.y(at));
        assertEquals(line, ys[i], LineShape.FAITHFUL + 0.02, "point " + i);
      }
    }
    assertEquals(ys[count - 1], shape.y(shape.size() - 1));
    assertEquals(xs[count - 1], shape.x(shape.size() - 1));
  }

  @Test
  void aStraightLineHasTwoPointsAndASmoothOneFew() {
    float[] xs = new float[1000];
    float[] ys = new float[1000];
    for (int i = 0; i < xs.length; i++) {
      xs[i] = i;
      ys[i] = 3 * i;
    }
    add(xs, ys);
    assertEquals(2, shape.size());
    assertEquals(3 * 999, shape.climb(), 1e-3);
    for (int i = 0; i < xs.length; i++) {
      ys[i] = (float) (100 * Math.sin(i / 100.0));
    }
    add(xs, ys);
    assertTrue(shape.size() < 120, "points: " + shape.size());
  }

  @Test
  void edgesOfStepsStay() {
    add(new float[]{0, 5, 5, 10, 10}, new float[]{1, 1, 9, 9, 1});
    assertEquals(5, shape.size());
    assertEquals(9, shape.y(2));
  }

  private void add(float[] xs, float[] ys) {
    shape.clear();
    for (int i = 0; i < xs.length; i++) {
      shape.add(xs[i], ys[i]);
    }
    shape.end();
  }
}
