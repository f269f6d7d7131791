package org.robotui.entity.path.internal.display;

import java.util.List;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.data.geometry.PoseArray;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.Anchor;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;

/** Arrows at the newest poses. */
final class PoseArrayDisplay implements Display {
  private final Recent<PoseArray, Instances> recent =
      new Recent<>(PoseArray.class, Anchor.When.NOW, PoseArray::frame, a -> 1);

  @Override
  public DisplayResult update(DisplayTick tick) {
    recent.update(tick);
    List<Part> parts =
        recent.newest().flatMap(e -> e.anchor().found().map(place -> part(e, place, tick))).stream().toList();
    List<RigidTransform> poses = recent.newest().map(e -> e.value().poses()).orElse(List.of());
    int drawn = parts.stream().mapToInt(part -> part.shape().elements()).findFirst().orElse(poses.size());
    return new DisplayResult(parts, recent.status(tick, status(poses.size(), drawn)), 0);
  }

  @Override
  public void close() {
    recent.clear();
  }

  private static DisplayStatus status(int count, int drawn) {
    if (count > PoseShapes.MOST) {
      return new DisplayStatus.Partly("the first " + PoseShapes.MOST + " of " + count + " poses");
    }
    return drawn < count
        ? new DisplayStatus.Partly(drawn + " of " + count + " poses; the others have numbers that are none")
        : new DisplayStatus.Shown(count + " poses");
  }

  private static Part part(Recent.Entry<PoseArray, Instances> entry, RigidTransform place, DisplayTick tick) {
    Settings s = tick.settings();
    boolean axes = s.text("poses").equals("axes");
    double length = s.number("length");
    Instances shape = entry.prepared(List.of(axes, length), array -> PoseShapes.of(array.poses(), axes, length));
    Rgba color = ColorSetting.read(s, "color");
    Rgba seen = color.withAlpha(color.alpha() * s.number("opacity") * Recent.opacity(tick));
    PoseArray array = entry.value();
    return new Part("poses", shape, place, PoseShapes.material(axes, seen), (element, at) -> describe(array, element));
  }

  /** Elements are the poses that are finite, in turn. */
  private static Properties describe(PoseArray array, int element) {
    List<RigidTransform> shown =
        array.poses().stream().filter(PoseShapes::finite).skip(Math.max(0, element)).limit(1).toList();
    return Optional.of(shown).filter(s -> !s.isEmpty() && element >= 0)
        .map(s -> PoseText.of("pose " + element, array.frame(), s.getFirst())).orElseGet(() -> Properties.of("poses"));
  }
}
