package org.robotui.entity.robotmodel.internal;

import java.util.Arrays;
import java.util.Optional;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.LineSet;

/** Where something was. When it has too many places, every second one is forgotten, so that the whole way stays. */
final class Trace {
  /** The most places. */
  static final int MOST = 20_000;
  private static final double STEP_METRES = 0.001;

  private float[] xyz = new float[3 * 256];
  private int size;
  private Optional<LineSet> line = Optional.empty();

  /** Takes a place, unless it is nearly the last one. */
  void add(Vector3 place) {
    if (size > 0 && place.minus(last()).norm() < STEP_METRES) {
      return;
    }
    if (size == MOST) {
      thin();
    }
    if (3 * size == xyz.length) {
      xyz = Arrays.copyOf(xyz, Math.min(3 * MOST, 2 * xyz.length));
    }
    xyz[3 * size] = (float) place.x();
    xyz[3 * size + 1] = (float) place.y();
    xyz[3 * size + 2] = (float) place.z();
    size++;
    line = Optional.empty();
  }

  int size() {
    return size;
  }

  /** The same object until another place or width comes. */
  LineSet line(float width) {
    if (line.filter(known -> known.width() == width).isEmpty()) {
      line = Optional.of(LineSet.of(LineSet.Kind.STRIP, width, Arrays.copyOf(xyz, 3 * size)));
    }
    return line.get();
  }

  private Vector3 last() {
    return new Vector3(xyz[3 * size - 3], xyz[3 * size - 2], xyz[3 * size - 1]);
  }

  private void thin() {
    for (int i = 0; 2 * i < size; i++) {
      System.arraycopy(xyz, 6 * i, xyz, 3 * i, 3);
    }
    size = (size + 1) / 2;
  }
}
