package org.robotui.data.sensor;

import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;
import org.robotui.data.array.Bytes;
import org.robotui.data.internal.Check;

/**
 * Points with named fields, kept as they came.
 *
 * @param frame frame of the points
 * @param width points a row
 * @param height rows; 1 for an unordered cloud
 * @param fields what a point consists of
 * @param pointStep bytes a point
 * @param rowStep bytes a row
 * @param order byte order of the numbers
 * @param dense true where no point has NaN coordinates
 * @param points the bytes, {@code height * rowStep} of them
 */
public record PointCloud(
    FrameId frame,
    int width,
    int height,
    List<PointField> fields,
    int pointStep,
    int rowStep,
    ByteOrder order,
    boolean dense,
    Bytes points)
    implements Data, InFrame {
  /**
   * Checks that the points fit into the bytes.
   *
   * @param frame frame of the points
   * @param width points a row
   * @param height rows
   * @param fields what a point consists of
   * @param pointStep bytes a point
   * @param rowStep bytes a row
   * @param order byte order
   * @param dense no NaN
   * @param points the bytes
   */
  public PointCloud {
    fields = List.copyOf(fields);
    Check.notNegative(width, "width");
    Check.notNegative(height, "height");
    Check.notNegative(pointStep, "pointStep");
    Check.that(pointStep > 0 || (long) width * height == 0, "pointStep", "must be positive, is " + pointStep);
    Check.that((long) width * pointStep <= rowStep, "rowStep", "too short for " + width + " points");
    Check.that((long) height * rowStep <= points.size(), "points", "too short for " + height + " rows of " + rowStep);
    for (PointField f : fields) {
      long end = f.offset() + (long) f.count() * f.format().size();
      Check.that(end <= pointStep, "field " + f.name(), "ends at " + end + ", behind the point of " + pointStep);
    }
  }

  /**
   * Finds a field.
   *
   * @param name its name
   * @return the field, or none
   */
  public Optional<PointField> field(String name) {
    return fields.stream().filter(f -> f.name().equals(name)).findFirst();
  }

  /**
   * How many points.
   *
   * @return width times height
   */
  public int size() {
    return width * height;
  }
}
