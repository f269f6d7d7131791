package org.robotui.entity.pointcloud.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.data.sensor.PointCloud;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.Anchor;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Rgba;

/** The newest cloud, or those of the last seconds: each a part of its own, so that what stays is not sent again. */
final class PointCloudDisplay implements Display {
  private final Recent<PointCloud, Prepared> recent =
      new Recent<>(PointCloud.class, Anchor.When.MEASURED, PointCloud::frame,
          cloud -> (long) cloud.width() * cloud.height());

  @Override
  public DisplayResult update(DisplayTick tick) {
    PointStyle look = PointStyle.of(tick.settings());
    recent.update(tick, tick.settings().number("decay"), look.most());
    double opacity = tick.settings().number("opacity");
    float paleness = Recent.paleness(tick);
    List<Part> parts = new ArrayList<>();
    for (Recent.Entry<PointCloud, Prepared> entry : recent.entries()) {
      entry.anchor().found().flatMap(place -> part(entry, place, look, opacity, paleness)).ifPresent(parts::add);
    }
    return new DisplayResult(parts, recent.status(tick, status(parts, look)), recent.dropped());
  }

  @Override
  public void close() {
    recent.clear();
  }

  private static Optional<Part> part(Recent.Entry<PointCloud, Prepared> entry, RigidTransform place, PointStyle look,
      double opacity, float pale) {
    Prepared prepared = prepare(entry, place, look);
    return prepared.shape().map(shape -> {
      Rgba color = shape.rgba().isPresent() ? Rgba.WHITE : look.flat();
      return new Part(entry.slot(), shape, place, Material.flat(color.withAlpha(color.alpha() * opacity)).paled(pale),
          new PointText(entry.value(), prepared.order().orElseThrow()));
    });
  }

  private static Prepared prepare(Recent.Entry<PointCloud, Prepared> entry, RigidTransform place, PointStyle look) {
    // The place counts only where the colours depend on it; else the shape stays the same while the cloud is moved.
    boolean placed = look.fixedAxis() && look.colorBy(entry.value()).equals("axis");
    return entry.prepared(List.of(look, placed ? place : ""), cloud -> Prepared.of(cloud, look, place));
  }

  private DisplayStatus status(List<Part> parts, PointStyle look) {
    Optional<Prepared> newest = recent.newest().flatMap(e -> e.anchor().found().map(place -> prepare(e, place, look)));
    Optional<String> complaint = newest.flatMap(Prepared::complaint);
    long points = parts.stream().mapToLong(part -> part.shape().elements()).sum();
    String words =
        String.format(Locale.ROOT, "%,d points", points) + (parts.size() > 1 ? " of " + parts.size() + " clouds" : "");
    if (newest.filter(n -> n.shape().isEmpty()).isPresent()) {
      return new DisplayStatus.Unfit(complaint.orElse(""));
    }
    if (complaint.isPresent()) {
      return new DisplayStatus.Partly(words + "; " + complaint.get());
    }
    return newest.filter(Prepared::thinned).isPresent()
        ? new DisplayStatus.Partly(words + ", an even part of " + recent.newest().map(e -> size(e.value())).orElse("")
            + "; most_points sets how many")
        : new DisplayStatus.Shown(words);
  }

  private static String size(PointCloud cloud) {
    return String.format(Locale.ROOT, "%,d", (long) cloud.width() * cloud.height());
  }
}
