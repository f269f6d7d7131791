package org.robotui.entity.wrench.internal.display;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.data.geometry.Wrench;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.Anchor;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Properties.Entry;

/** The newest force and torque, where its sensor is now. */
final class WrenchDisplay implements Display {
  private final Recent<Wrench, WrenchShapes> recent =
      new Recent<>(Wrench.class, Anchor.When.NOW, Wrench::frame, wrench -> 1);

  @Override
  public DisplayResult update(DisplayTick tick) {
    recent.update(tick);
    Optional<Recent.Entry<Wrench, WrenchShapes>> newest = recent.newest();
    if (newest.isEmpty() || !finite(newest.get().value())) {
      DisplayStatus broken = new DisplayStatus.Unfit("the sensor says what is no number");
      return DisplayResult
          .nothing(newest.isEmpty() ? recent.status(tick, new DisplayStatus.Shown("")) : recent.status(tick, broken));
    }
    Settings settings = tick.settings();
    WrenchShapes.Scale scale =
        new WrenchShapes.Scale(settings.number(WrenchType.FORCE_SCALE), settings.number(WrenchType.TORQUE_SCALE),
            settings.number(WrenchType.WIDTH), settings.number(WrenchType.LONGEST));
    WrenchShapes shapes = newest.get().prepared(scale, wrench -> WrenchShapes.of(wrench, scale));
    List<Part> parts =
        newest.get().anchor().found().map(at -> parts(newest.get().value(), shapes, at, tick)).orElse(List.of());
    return new DisplayResult(parts, recent.status(tick, seen(newest.get().value(), shapes)), recent.dropped());
  }

  private static boolean finite(Wrench wrench) {
    return wrench.force().isFinite() && wrench.torque().isFinite();
  }

  private static DisplayStatus seen(Wrench wrench, WrenchShapes shapes) {
    String words = String.format(Locale.ROOT, "%.2f N, %.2f Nm", wrench.force().norm(), wrench.torque().norm());
    return shapes.cut().isEmpty() ? new DisplayStatus.Shown(words)
        : new DisplayStatus.Partly(
            words + ": " + shapes.cut() + " would be longer than it is drawn; lower the scale, or raise longest");
  }

  private static List<Part> parts(Wrench wrench, WrenchShapes shapes, RigidTransform at, DisplayTick tick) {
    float opacity = Recent.opacity(tick);
    Material force = Material.lit(ColorSetting.read(tick.settings(), WrenchType.FORCE_COLOR).withAlpha(opacity));
    Material torque = Material.lit(ColorSetting.read(tick.settings(), WrenchType.TORQUE_COLOR).withAlpha(opacity));
    Material ring = Material.flat(torque.color());
    List<Part> parts = new ArrayList<>();
    Describer describer = describer(wrench);
    shapes.force()
        .ifPresent(solid -> parts.add(new Part("force", solid.mesh(), at.times(solid.turn()), force, describer)));
    shapes.torque()
        .ifPresent(solid -> parts.add(new Part("torque", solid.mesh(), at.times(solid.turn()), torque, describer)));
    shapes.ring().ifPresent(shape -> parts.add(new Part("ring", shape, at, ring, describer)));
    return parts;
  }

  private static Describer describer(Wrench wrench) {
    return (element, place) -> Properties.of("Force and torque",
        new Entry("frame", wrench.frame().name()), new Entry("force", words(wrench.force(), "N")),
        new Entry("torque", words(wrench.torque(), "Nm")));
  }

  private static String words(Vector3 v, String unit) {
    return String.format(Locale.ROOT, "%.3f %s (%.3f, %.3f, %.3f)", v.norm(), unit, v.x(), v.y(), v.z());
  }

  @Override
  public void close() {
    recent.clear();
  }
}
