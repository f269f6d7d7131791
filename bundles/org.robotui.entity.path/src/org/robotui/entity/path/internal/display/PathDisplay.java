package org.robotui.entity.path.internal.display;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.data.navigation.Path;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.Anchor;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;

/** The newest way: a line, and its poses where they are asked for. */
final class PathDisplay implements Display {
  private final Recent<Path, Made> recent = new Recent<>(Path.class, Anchor.When.NOW, Path::frame, path -> 1);

  /** What is drawn of a way. */
  private record Made(List<RigidTransform> poses, LineSet line, Optional<Instances> marks, double length) {}

  @Override
  public DisplayResult update(DisplayTick tick) {
    recent.update(tick);
    List<Part> parts = new ArrayList<>();
    Optional<Made> made = recent.newest().map(entry -> prepare(entry, tick.settings()));
    recent.newest().flatMap(e -> e.anchor().found()).ifPresent(place -> add(parts, made.orElseThrow(), place, tick));
    return new DisplayResult(parts,
        recent.status(tick, made.map(this::status).orElseGet(() -> new DisplayStatus.NoData(""))), 0);
  }

  @Override
  public void close() {
    recent.clear();
  }

  private DisplayStatus status(Made made) {
    int left = recent.newest().map(e -> e.value().poses().size()).orElse(0) - made.poses().size();
    String words = made.poses().isEmpty() ? "no path"
        : String.format(Locale.ROOT, "%.2f m, %d poses", made.length(), made.poses().size());
    return left > 0 ? new DisplayStatus.Partly(words + "; " + left + " poses are no numbers, or too many")
        : new DisplayStatus.Shown(words);
  }

  private static Made prepare(Recent.Entry<Path, Made> entry, Settings s) {
    String poses = s.text("poses");
    return entry.prepared(List.of(poses, s.number("length"), s.number("width")), path -> make(path, poses, s));
  }

  private static Made make(Path path, String marks, Settings s) {
    List<RigidTransform> poses = path.poses().stream().filter(PoseShapes::finite)
        .limit(PoseShapes.MOST).toList();
    float[] xyz = new float[3 * poses.size()];
    double length = 0;
    for (int i = 0; i < poses.size(); i++) {
      Vector3 at = poses.get(i).translation();
      xyz[3 * i] = (float) at.x();
      xyz[3 * i + 1] = (float) at.y();
      xyz[3 * i + 2] = (float) at.z();
      length += i > 0 ? at.minus(poses.get(i - 1).translation()).norm() : 0;
    }
    Optional<Instances> instances = marks.equals("none")
        ? Optional.empty()
        : Optional.of(PoseShapes.of(poses, marks.equals("axes"), s.number("length")));
    return new Made(poses, LineSet.of(LineSet.Kind.STRIP, (float) s.number("width"), xyz), instances, length);
  }

  private void add(List<Part> parts, Made made, RigidTransform place, DisplayTick tick) {
    Settings s = tick.settings();
    Rgba color = ColorSetting.read(s, "color");
    Rgba seen = color.withAlpha(color.alpha() * s.number("opacity") * Recent.opacity(tick));
    RigidTransform lifted = place.times(new RigidTransform(new Vector3(0, 0, s.number("height")), Quaternion.IDENTITY));
    Path path = recent.newest().orElseThrow().value();
    parts.add(
        new Part("line", made.line(), lifted, Material.flat(seen), (element, at) -> describe(path, made, element)));
    made.marks().ifPresent(marks -> parts.add(new Part("poses", marks, lifted,
        PoseShapes.material(s.text("poses").equals("axes"), seen), (element, at) -> describe(path, made, element))));
  }

  private static Properties describe(Path path, Made made, int element) {
    return element < 0 || element >= made.poses().size()
        ? Properties.of("path")
        : PoseText.of("path, pose " + element + " of " + made.poses().size(), path.frame(), made.poses().get(element));
  }
}
