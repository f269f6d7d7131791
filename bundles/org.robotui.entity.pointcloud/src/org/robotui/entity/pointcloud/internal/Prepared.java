package org.robotui.entity.pointcloud.internal;

import java.nio.ByteBuffer;
import java.util.Optional;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.PointSet;

/**
 * What is drawn of a cloud.
 *
 * @param shape its points, none where it has no coordinates
 * @param order which point is which
 * @param complaint why it is not drawn, or not as it was asked
 */
record Prepared(Optional<PointSet> shape, Optional<Order> order, Optional<String> complaint) {
  static Prepared of(PointCloud cloud, PointStyle look, RigidTransform fixedFromCloud) {
    return CloudPoints.of(cloud, look.most())
        .map(points -> draw(cloud, look, fixedFromCloud, points))
        .orElseGet(() -> new Prepared(Optional.empty(), Optional.empty(),
            Optional.of("the cloud has no fields x, y and z; it has " + names(cloud))));
  }

  /** Whether some points were left out. */
  boolean thinned() {
    return order.filter(o -> o.count() < o.total()).isPresent();
  }

  private static Prepared draw(PointCloud cloud, PointStyle look, RigidTransform fixedFromCloud, CloudPoints points) {
    Optional<ByteBuffer> rgba;
    Optional<String> complaint = Optional.empty();
    switch (look.colorBy(cloud)) {
      case "axis" -> {
        RigidTransform to = look.fixedAxis() ? fixedFromCloud : RigidTransform.IDENTITY;
        rgba = Optional.of(Values.colors(Values.along(look.axis(), points.xyz(), to), look));
      }
      case "field" -> {
        Optional<PointField> field = cloud.field(look.field());
        rgba = field.map(f -> Values.colors(Values.of(cloud, f, points.order()), look));
        complaint = field.isPresent() ? complaint
            : Optional.of("no field " + look.field() + " to colour by; there are " + names(cloud));
      }
      case "rgb" -> {
        Optional<PointField> field = Packed.in(cloud);
        rgba = field.map(f -> Packed.colors(cloud, f, points.order()));
        complaint = field.isPresent() ? complaint
            : Optional.of("no field rgb or rgba of four bytes; there are " + names(cloud));
      }
      default -> rgba = Optional.empty();
    }
    PointSet shape = Sample.in(new PointSet(points.xyz(), rgba, look.size(), look.unit(), look.style(),
        Box3.around(points.xyz()), Optional.empty()));
    return new Prepared(Optional.of(shape), Optional.of(points.order()), complaint);
  }

  private static String names(PointCloud cloud) {
    return cloud.fields().isEmpty() ? "none"
        : String.join(", ", cloud.fields().stream().limit(20).map(PointField::name).toList());
  }
}
