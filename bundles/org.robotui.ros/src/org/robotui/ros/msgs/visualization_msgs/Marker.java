package org.robotui.ros.msgs.visualization_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.message.Stamps;
import org.robotui.ros.msgs.geometry_msgs.Pose;
import org.robotui.ros.msgs.geometry_msgs.Vector3;
import org.robotui.ros.msgs.std_msgs.ColorRGBA;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Something to be shown in space ({@code visualization_msgs/Marker}).
 *
 * @param header                   time and frame
 * @param ns                       with the id, the name of the marker
 * @param id                       with the namespace, the name of the marker
 * @param type                     what it looks like, one of the types
 * @param action                   what becomes of it, one of the actions
 * @param pose                     where it is
 * @param scale                    its size, metres; what each number means depends on the type
 * @param color                    its colour
 * @param lifetime                 nanoseconds until it goes by itself; 0 for never
 * @param frameLocked              whether it moves with its frame
 * @param points                   x, y, z in turn, for the types that have points
 * @param colors                   red, green, blue, alpha in turn, one colour a point or none
 * @param text                     of texts
 * @param meshResource             address of the file of a mesh
 * @param meshUseEmbeddedMaterials whether the file's own colours count
 */
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

  private static final int POINT = 3 * Double.BYTES;
  private static final int COLOR = 4 * Float.BYTES;

  /** Between records and bytes. */
  public static final RecordCodec<Marker> CODEC =
      RecordCodec.of("visualization_msgs/Marker", Marker::read, Marker::write);

  /** Keeps immutable copies of lists, and checks that numbers come in whole points and colours. */
  public Marker {
    RecordCodec.requireLength("points", points.length, points.length / 3 * 3);
    RecordCodec.requireLength("colors", colors.length, colors.length / 4 * 4);
  }

  private static Marker read(MessageReader in) throws MessageException {
    return new Marker(
        in.nested("header", Header.CODEC),
        in.string("ns"),
        in.int32("id"),
        in.int32("type"),
        in.int32("action"),
        in.nested("pose", Pose.CODEC),
        in.nested("scale", Vector3.CODEC),
        in.nested("color", ColorRGBA.CODEC),
        in.duration("lifetime"),
        in.bool("frame_locked"),
        in.doubles("points", 3 * in.count("points", POINT)),
        in.floats("colors", 4 * in.count("colors", COLOR)),
        in.string("text"),
        in.string("mesh_resource"),
        in.bool("mesh_use_embedded_materials"));
  }

  private static void write(Marker m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.string(m.ns);
    out.i32(m.id);
    out.i32(m.type);
    out.i32(m.action);
    Pose.CODEC.encode(m.pose, out);
    Vector3.CODEC.encode(m.scale, out);
    ColorRGBA.CODEC.encode(m.color, out);
    Stamps.write(m.lifetime, out);
    out.bool(m.frameLocked);
    out.array(m.points.length / 3).doubles(m.points);
    out.array(m.colors.length / 4).floats(m.colors);
    out.string(m.text);
    out.string(m.meshResource);
    out.bool(m.meshUseEmbeddedMaterials);
  }
}
