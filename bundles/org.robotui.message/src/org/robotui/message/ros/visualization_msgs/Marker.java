package org.robotui.message.ros.visualization_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.std_msgs.ColorRGBA;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Something to be shown in space ({@code visualization_msgs/Marker}).
 *
 * @param header time and frame
 * @param ns with the id, the name of the marker
 * @param id with the namespace, the name of the marker
 * @param type what it looks like, one of the types
 * @param action what becomes of it, one of the actions
 * @param pose where it is
 * @param scale its size, metres; what each number means depends on the type
 * @param color its colour
 * @param lifetime nanoseconds until it goes by itself; 0 for never
 * @param frameLocked whether it moves with its frame
 * @param points x, y, z in turn, for the types that have points
 * @param colors red, green, blue, alpha in turn, one colour a point or none
 * @param text of texts
 * @param meshResource address of the file of a mesh
 * @param meshUseEmbeddedMaterials whether the file's own colours count
 */
@MessageType("visualization_msgs/Marker")
public record Marker(
    Header header,
    String ns,
    int id,
    int type,
    int action,
    Pose pose,
    Vector3 scale,
    ColorRGBA color,
    long lifetime,
    boolean frameLocked,
    double[] points,
    float[] colors,
    String text,
    String meshResource,
    boolean meshUseEmbeddedMaterials) {

  /** Along x, or from the first to the second point. */
  public static final int ARROW = 0;
  /** A box. */
  public static final int CUBE = 1;
  /** An ellipsoid. */
  public static final int SPHERE = 2;
  /** Along z. */
  public static final int CYLINDER = 3;
  /** Each point to the next. */
  public static final int LINE_STRIP = 4;
  /** Points in pairs. */
  public static final int LINE_LIST = 5;
  /** A cube at each point. */
  public static final int CUBE_LIST = 6;
  /** A sphere at each point. */
  public static final int SPHERE_LIST = 7;
  /** Flat points. */
  public static final int POINTS = 8;
  /** Text that faces the viewer. */
  public static final int TEXT_VIEW_FACING = 9;
  /** A mesh from a file. */
  public static final int MESH_RESOURCE = 10;
  /** Points in triples. */
  public static final int TRIANGLE_LIST = 11;
  /** Adds or changes it. */
  public static final int ADD = 0;
  /** Takes it away. */
  public static final int DELETE = 2;
  /** Takes all of the topic away. */
  public static final int DELETEALL = 3;
}
