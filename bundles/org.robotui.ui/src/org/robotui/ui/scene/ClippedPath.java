package org.robotui.ui.scene;

import java.util.Arrays;
import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.Path;

/**
 * Lines and areas as paths that end far outside of any window: the fixed-point numbers of the toolkit end at some
 * millions of pixels, and a dashed line takes time for each dash, whether it is seen or not. Corners that are no
 * numbers are left out.
 */
final class ClippedPath {
  /** Twice as far as the largest window reaches, pixels. */
  static final double FAR = 20_000;
  /** Farther corners are taken for ones that lie here, pixels, so that no difference of two is infinite. */
  private static final double FARTHEST = 1e12;

  private ClippedPath() {}

  /** The line through pixels, x and y in turn; to be disposed. */
  static Path line(Device device, double[] xy) {
    Path path = new Path(device);
    if (isNear(xy)) {
      trace(path, xy);
    } else {
      pieces(path, finite(xy));
    }
    return path;
  }

  /** The area between pixels, x and y in turn, with its edge; to be disposed. */
  static Path area(Device device, double[] xy) {
    Path path = new Path(device);
    addArea(path, xy);
    return path;
  }

  static void addArea(Path path, double[] xy) {
    double[] seen = xy;
    if (!isNear(xy)) {
      seen = finite(xy);
      for (int side = 0; side < 4; side++) {
        seen = cut(seen, side % 2, side < 2 ? 1 : -1);
      }
    }
    if (seen.length > 0) {
      trace(path, seen);
      path.close();
    }
  }

  private static boolean isNear(double[] xy) {
    for (double at : xy) {
      if (!(Math.abs(at) <= FAR)) {
        return false;
      }
    }
    return true;
  }

  private static void trace(Path path, double[] xy) {
    for (int i = 0; i + 1 < xy.length; i += 2) {
      if (i == 0) {
        path.moveTo((float) xy[0], (float) xy[1]);
      } else {
        path.lineTo((float) xy[i], (float) xy[i + 1]);
      }
    }
  }

  private static double[] finite(double[] xy) {
    double[] kept = new double[xy.length];
    int size = 0;
    for (int i = 0; i + 1 < xy.length; i += 2) {
      if (!Double.isNaN(xy[i]) && !Double.isNaN(xy[i + 1])) {
        kept[size++] = Math.clamp(xy[i], -FARTHEST, FARTHEST);
        kept[size++] = Math.clamp(xy[i + 1], -FARTHEST, FARTHEST);
      }
    }
    return Arrays.copyOf(kept, size);
  }

  /** What is left of each edge of a line between the four sides, as Liang and Barsky do it. */
  private static void pieces(Path path, double[] xy) {
    boolean goesOn = false;
    for (int i = 0; i + 3 < xy.length; i += 2) {
      double dx = xy[i + 2] - xy[i];
      double dy = xy[i + 3] - xy[i + 1];
      double from = Math.max(Math.max(0, enter(xy[i], dx)), enter(xy[i + 1], dy));
      double to = Math.min(Math.min(1, leave(xy[i], dx)), leave(xy[i + 1], dy));
      if (from <= to) {
        if (!goesOn || from > 0) {
          path.moveTo((float) (xy[i] + from * dx), (float) (xy[i + 1] + from * dy));
        }
        path.lineTo((float) (xy[i] + to * dx), (float) (xy[i + 1] + to * dy));
      }
      goesOn = from <= to && to == 1;
    }
  }

  /** The share of the way from a coordinate at which it comes within reach; beyond the whole way where it does not. */
  private static double enter(double at, double by) {
    return by == 0 ? Math.abs(at) <= FAR ? 0 : 2 : ((by > 0 ? -FAR : FAR) - at) / by;
  }

  private static double leave(double at, double by) {
    return by == 0 ? 1 : ((by > 0 ? FAR : -FAR) - at) / by;
  }

  /** What of an area lies on the inner side of one of the four sides, as Sutherland and Hodgman do it. */
  private static double[] cut(double[] xy, int axis, int sign) {
    double[] kept = new double[2 * xy.length];
    int size = 0;
    for (int i = 0; i + 1 < xy.length; i += 2) {
      int before = (i + xy.length - 2) % xy.length;
      boolean inside = sign * xy[i + axis] <= FAR;
      if (inside != sign * xy[before + axis] <= FAR) {
        double share = (sign * FAR - xy[before + axis]) / (xy[i + axis] - xy[before + axis]);
        kept[size++] = xy[before] + share * (xy[i] - xy[before]);
        kept[size++] = xy[before + 1] + share * (xy[i + 1] - xy[before + 1]);
      }
      if (inside) {
        kept[size++] = xy[i];
        kept[size++] = xy[i + 1];
      }
    }
    return Arrays.copyOf(kept, size);
  }
}
