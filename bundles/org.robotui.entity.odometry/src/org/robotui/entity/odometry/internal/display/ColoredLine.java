package org.robotui.entity.odometry.internal.display;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Locale;
import java.util.Optional;
import org.robotui.entity.odometry.internal.colored.ColoredTrail;
import org.robotui.entity.odometry.internal.colored.WayPoints;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.ColorScale;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;

/** A way in space whose colours tell a value; made anew where another one is to be seen. */
final class ColoredLine {
  private static final float WIDTH = 4;
  private static final int GREY = 0x808080;
  private static final int OPAQUE = 0xff;
  /** Above the ground, which would cover it here and there. */
  private static final RigidTransform LIFT = new RigidTransform(new Vector3(0, 0, 0.02), Quaternion.IDENTITY);

  private Optional<Made> made = Optional.empty();

  private record Made(ColoredTrail.Seen of, LineSet shape) {}

  Part part(ColoredTrail.Seen seen, RigidTransform place, double opacity) {
    if (made.filter(m -> m.of == seen).isEmpty()) {
      made = Optional.of(new Made(seen, shape(seen)));
    }
    return new Part("way", made.orElseThrow().shape, place.times(LIFT), Material.flat(Rgba.WHITE.withAlpha(opacity)),
        (element, at) -> describe(seen, element));
  }

  void clear() {
    made = Optional.empty();
  }

  private static LineSet shape(ColoredTrail.Seen seen) {
    WayPoints way = seen.way();
    float[] xyz = new float[3 * way.count()];
    ByteBuffer rgba = ByteBuffer.allocate(Integer.BYTES * way.count());
    for (int i = 0; i < way.count(); i++) {
      for (int c = 0; c < 3; c++) {
        xyz[3 * i + c] = (float) way.xyz()[3 * i + c];
      }
      double value = way.values()[i];
      rgba.putInt(seen.scale().map(scale -> scale.rgb(value)).orElse(GREY) << Byte.SIZE | OPAQUE);
    }
    FloatBuffer corners = FloatBuffer.wrap(xyz);
    return new LineSet(corners, Optional.of(rgba.flip()), LineSet.Kind.STRIP, WIDTH, Box3.around(corners));
  }

  private static Properties describe(ColoredTrail.Seen seen, int element) {
    WayPoints way = seen.way();
    int at = element + 1; // an element leads to the next place
    if (element < 0 || at >= way.count() || Double.isNaN(way.values()[at]) || seen.scale().isEmpty()) {
      return Properties.of("way");
    }
    ColorScale scale = seen.scale().get();
    return Properties.of("way", new Properties.Entry(scale.title(),
        String.format(Locale.ROOT, "%.3f %s", way.values()[at], scale.unit()).strip()));
  }
}
