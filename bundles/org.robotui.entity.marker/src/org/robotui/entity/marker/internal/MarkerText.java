package org.robotui.entity.marker.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.robotui.data.marker.Color;
import org.robotui.data.marker.Marker;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Properties.Entry;

/** What markers say when they are selected. */
final class MarkerText {
  private MarkerText() {}

  static Properties of(Marker m, int element) {
    List<Entry> entries = new ArrayList<>();
    entries.add(new Entry("Namespace", m.key().namespace()));
    entries.add(new Entry("Id", String.valueOf(m.key().id())));
    entries.add(new Entry("Type", m.type().name().toLowerCase(Locale.ROOT).replace('_', ' ')));
    entries.add(new Entry("Frame", m.frame().name() + (m.locked() ? ", moves with it" : "")));
    entries.add(new Entry("Position", vector(m.pose().translation()) + " m"));
    entries.add(new Entry("Scale", vector(m.scale())));
    Color c = m.color();
    entries.add(new Entry("Colour",
        String.format(Locale.ROOT, "%.2f %.2f %.2f, alpha %.2f", c.red(), c.green(), c.blue(), c.alpha())));
    if (m.lifetimeNanos() > 0) {
      entries.add(new Entry("Lifetime", String.format(Locale.ROOT, "%.1f s", m.lifetimeNanos() * 1e-9)));
    }
    if (!m.text().isEmpty()) {
      entries.add(new Entry("Text", m.text()));
    }
    if (m.points().size() > 0) {
      entries.add(new Entry("Element", element + " of " + m.points().size() / 3 + " points"));
    }
    return new Properties("Marker " + m.key(), entries);
  }

  private static String vector(Vector3 v) {
    return String.format(Locale.ROOT, "%.3f %.3f %.3f", v.x(), v.y(), v.z());
  }
}
