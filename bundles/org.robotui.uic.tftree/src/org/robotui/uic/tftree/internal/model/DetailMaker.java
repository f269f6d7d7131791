package org.robotui.uic.tftree.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.api.frame.FrameLink;
import org.robotui.api.frame.Frames;
import org.robotui.api.time.RobotClock;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.TransformLookup;
import org.robotui.ui.Figures;
import org.robotui.uic.tftree.internal.model.Ask.Reference;
import org.robotui.uic.tftree.internal.model.FrameDetail.Value;

/** Says where a frame lies now, and all that is known of its transform. Never blocks. */
final class DetailMaker {
  private static final int DECIMALS = 3;

  private final Frames frames;
  private final RobotClock clock;

  DetailMaker(Frames frames, RobotClock clock) {
    this.frames = frames;
    this.clock = clock;
  }

  FrameDetail of(FrameId frame, Reference wanted, Forest forest, Optional<FrameRow> row) {
    FrameId reference = switch (wanted) {
      case Reference.Root r -> forest.root(frame);
      case Reference.Parent p -> forest.parent(frame).orElse(frame);
      case Reference.Pinned pinned -> pinned.frame();
    };
    TransformLookup<FrameId> found = frames.lookup(reference, frame, Optional.empty());
    List<Value> values = new ArrayList<>();
    found.transform().ifPresent(pose -> pose(pose, values));
    row.ifPresent(r -> transform(r, values));
    return new FrameDetail(frame, reference, Optional.of(found.explanation()).filter(why -> !why.isEmpty()), values);
  }

  private static void pose(RigidTransform pose, List<Value> values) {
    Quaternion q = pose.rotation();
    values.add(new Value("x", Figures.of(pose.translation().x(), DECIMALS, "m")));
    values.add(new Value("y", Figures.of(pose.translation().y(), DECIMALS, "m")));
    values.add(new Value("z", Figures.of(pose.translation().z(), DECIMALS, "m")));
    values.add(new Value("roll", angle(q.roll())));
    values.add(new Value("pitch", angle(q.pitch())));
    values.add(new Value("yaw", angle(q.yaw())));
    values
        .add(new Value("quaternion", String.format(Locale.ROOT, "%.3f, %.3f, %.3f, %.3f", q.x(), q.y(), q.z(), q.w())));
    values.add(new Value("distance", Figures.of(pose.translation().norm(), DECIMALS, "m")));
  }

  private static String angle(double radians) {
    return Figures.degrees(radians, 2) + "  " + Figures.of(radians, 4, "rad");
  }

  private void transform(FrameRow row, List<Value> values) {
    values.add(new Value("parent", row.link().map(link -> link.parent().name()).orElse("none: it is a root")));
    values.add(new Value("below", row.below() + (row.below() == 1 ? " frame" : " frames")));
    row.link().ifPresent(link -> {
      values.add(new Value("transform", link.fixed() ? "static" : "moving, " + Figures.rate(link.rateHz())));
      values.add(new Value("sent by", link.authority().isBlank() ? Figures.UNKNOWN : link.authority()));
      if (!link.fixed()) {
        values.add(new Value("came", Figures.age(row.age()) + " ago"));
        values.add(new Value("stamp", link.newest().map(this::stamp).orElse(Figures.UNKNOWN)));
        values.add(new Value("held", Figures.of(link.heldSeconds(), 1, "s") + ", " + link.samples() + " transforms"));
      }
      rivals(link, values);
    });
  }

  private static void rivals(FrameLink link, List<Value> values) {
    if (!link.rivals().isEmpty()) {
      values.add(new Value("also published by", link.rivals().stream()
          .map(rival -> rival.authority() + " in " + rival.parent().name()).collect(Collectors.joining(", "))));
    }
  }

  private String stamp(Stamp newest) {
    Stamp now = clock.now();
    String at = String.format(Locale.ROOT, "%.3f", newest.seconds());
    return now.clock() == newest.clock()
        ? at + ", " + Figures.ageOfValue((now.nanos() - newest.nanos()) * 1e-9) + " old"
        : at;
  }
}
