package org.robotui.rfic.lcm.internal.convert;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.robotui.data.array.Doubles;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.rfic.lcm.internal.language.Field;
import org.robotui.rfic.lcm.internal.language.Form;
import org.robotui.rfic.lcm.internal.language.Quantity;
import org.robotui.rfic.lcm.internal.language.Values;

/** Where things are and go. */
final class MotionShapes {
  private static final String PLACE = "position | x y";

  private MotionShapes() {}

  static Stream<Shape<?>> all() {
    return Stream.of(
        new Shape<>(Form.of("odometry", List.of(PLACE), fields(Poses.fields(), velocities(),
            Stream.of(Field.text("frame", "frame"), Field.text("child", "child_frame"), Field.stamp()))),
            Odometry.class, MotionShapes::odometry),
        new Shape<>(Form.of("pose", List.of(PLACE), fields(Poses.fields(), Stream.of(Field.text("frame", "frame"),
            Field.numbers("covariance", Quantity.PLAIN, "covariance"), Field.stamp()))), PoseEstimate.class,
            MotionShapes::estimate),
        new Shape<>(Form.of("path", List.of(PLACE), ways()), Path.class,
            (v, r) -> new Path(r.frame(v.text("frame", "map")), Poses.all(v, Poses.count(v)))),
        new Shape<>(Form.of("poses", List.of(PLACE), ways()), PoseArray.class,
            (v, r) -> new PoseArray(r.frame(v.text("frame", "map")), Poses.all(v, Poses.count(v)))),
        new Shape<>(Form.of("transform", List.of("parent", "child", PLACE),
            fields(Poses.fields(), ends("", "child_frame"),
                Stream.of(Field.flag("fixed"), Field.stamp()))),
            TransformSet.class, MotionShapes::transforms),
        new Shape<>(Form.of("transforms", List.of("parent", "child", PLACE),
            fields(Poses.fields("transforms"), ends("transforms[].", "transforms[].child"),
                Stream.of(Field.flag("fixed"), Field.stamp()))),
            TransformSet.class, MotionShapes::transforms));
  }

  private static Stream<Field> ends(String before, String otherChild) {
    return Stream.of(Field.texts("parent", before + "parent"), Field.texts("child", before + "child", otherChild));
  }

  private static List<Field> ways() {
    return fields(Poses.fields("poses", "waypoints", "points"), Stream.of(Field.text("frame", "frame"), Field.stamp()));
  }

  /** The fields of a velocity. */
  static Stream<Field> velocities() {
    return Stream.of(
        Field.numbers("linear", Quantity.SPEED, "linear_velocity", "linear", "vel"),
        Field.number("vx", Quantity.SPEED).in("linear"), Field.number("vy", Quantity.SPEED).in("linear"),
        Field.number("vz", Quantity.SPEED).in("linear"),
        Field.numbers("angular", Quantity.TURN_RATE, "angular_velocity", "angular", "rotation_rate"),
        Field.number("wx", Quantity.TURN_RATE).in("angular"), Field.number("wy", Quantity.TURN_RATE).in("angular"),
        Field.number("wz", Quantity.TURN_RATE).in("angular"));
  }

  @SafeVarargs
  static List<Field> fields(Stream<Field>... parts) {
    return Stream.of(parts).flatMap(part -> part).toList();
  }

  private static Odometry odometry(Values v, Reception r) {
    return new Odometry(r.frame(v.text("frame", "odom")), r.frame(v.text("child", "base")), Poses.one(v), Doubles.EMPTY,
        Poses.vector(v, "linear", "vx", "vy", "vz"), Poses.vector(v, "angular", "wx", "wy", "wz"), Doubles.EMPTY);
  }

  private static PoseEstimate estimate(Values v, Reception r) {
    return new PoseEstimate(r.frame(v.text("frame", "map")), Poses.one(v), Doubles.wrap(v.numbers("covariance")));
  }

  private static TransformSet transforms(Values v, Reception r) {
    List<String> parents = v.texts("parent");
    List<String> children = v.texts("child");
    int count = Math.max(parents.size(), children.size());
    List<RigidTransform> poses = Poses.all(v, count);
    List<FrameTransform> transforms = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      transforms.add(new FrameTransform(r.frame(at(parents, i, count, "parent")),
          r.frame(at(children, i, count, "child")), r.stamp(),
          poses.get(i), v.flag("fixed")));
    }
    TransformSet set = new TransformSet(transforms);
    if (count > 0) {
      r.transforms().accept(set);
    }
    return set;
  }

  private static String at(List<String> texts, int i, int count, String field) {
    if (texts.size() != 1 && texts.size() != count) {
      throw new IllegalArgumentException(field + " names " + texts.size() + " frames of " + count);
    }
    return texts.get(texts.size() == 1 ? 0 : i);
  }
}
