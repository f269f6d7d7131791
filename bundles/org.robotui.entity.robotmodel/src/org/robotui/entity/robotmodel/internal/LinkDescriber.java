package org.robotui.entity.robotmodel.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Properties;
import org.robotui.urdf.Joint;
import org.robotui.urdf.Link;

/** Says what a link is: its joint and where that is, and what it weighs. */
record LinkDescriber(Loaded.Model loaded, Link link, Supplier<Map<String, Double>> positions) implements Describer {
  @Override
  public Properties describe(int element, Vector3 place) {
    List<Properties.Entry> entries = new ArrayList<>();
    entries.add(new Properties.Entry("Robot", loaded.model().name()));
    loaded.model().carrier(link.name()).ifPresent(joint -> describe(joint, entries));
    link.inertial().ifPresent(inertial -> entries.add(new Properties.Entry("Mass", number(inertial.mass()) + " kg")));
    return new Properties(link.name(), entries);
  }

  private void describe(Joint joint, List<Properties.Entry> entries) {
    entries.add(new Properties.Entry("Joint", joint.name() + ", " + joint.type().name().toLowerCase(Locale.ROOT)));
    entries.add(new Properties.Entry("On", joint.parent()));
    if (!joint.type().single()) {
      return;
    }
    String unit = joint.type() == Joint.Type.PRISMATIC ? " m" : " rad";
    position(joint).ifPresent(position -> entries.add(new Properties.Entry("Position", number(position) + unit)));
    joint.limits().filter(limits -> joint.type() != Joint.Type.CONTINUOUS).ifPresent(limits -> entries
        .add(new Properties.Entry("Limits", number(limits.lower()) + " to " + number(limits.upper()) + unit)));
    joint.mimic().ifPresent(mimic -> entries.add(new Properties.Entry("Follows", mimic.joint())));
  }

  private Optional<Double> position(Joint joint) {
    Map<String, Double> known = positions.get();
    boolean told =
        known.containsKey(joint.name()) || joint.mimic().filter(mimic -> known.containsKey(mimic.joint())).isPresent();
    return told ? Optional.of(loaded.kinematics().position(joint, known)) : Optional.empty();
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.4g", value);
  }
}
