package org.robotui.rfic.gazebo.internal.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.data.marker.Color;
import org.robotui.data.marker.Marker;
import org.robotui.data.marker.MarkerSet;
import org.robotui.data.record.DynamicRecord;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** What stands in a world as markers: boxes, cylinders, spheres, planes and meshes, in the frames of their links. */
public final class SceneMarkers {
  private static final double FLAT = 0.001;
  private static final Color GREY = new Color(0.6f, 0.6f, 0.6f, 1);

  private SceneMarkers() {}

  /** What a geometry is drawn as. */
  private record Form(Marker.Type type, Vector3 scale, String mesh) {}

  /**
   * All of a scene.
   *
   * @param robot whose frames they are in
   * @param scene what stands in the world
   * @return the markers, in the place of all before
   */
  public static MarkerSet of(String robot, KnownScene scene) {
    List<MarkerSet.Entry> entries = new ArrayList<>();
    for (KnownScene.Look look : scene.looks()) {
      form(look.visual()).ifPresent(form -> {
        Marker.Key key = new Marker.Key(look.frame(), entries.size());
        entries.add(new MarkerSet.Entry(key, Optional.of(marker(key, new FrameId(robot, look.frame()), look, form))));
      });
    }
    return new MarkerSet(true, entries);
  }

  private static Marker marker(Marker.Key key, FrameId frame, KnownScene.Look look, Form form) {
    return new Marker(key, frame, Optional.empty(), System.nanoTime(), form.type(), pose(look.visual()), form.scale(),
        color(look.visual()), 0, true, Floats.EMPTY, Bytes.EMPTY, "", form.mesh(), !form.mesh().isEmpty());
  }

  private static Optional<Form> form(DynamicRecord visual) {
    return SceneFields.inner(visual, "geometry").flatMap(geometry -> switch (SceneFields.text(geometry, "type")) {
      case "BOX" -> of(geometry, "box").map(box -> new Form(Marker.Type.CUBE, vector(box, "size"), ""));
      case "SPHERE" -> of(geometry, "sphere").map(each -> new Form(Marker.Type.SPHERE, round(each, 0, true), ""));
      case "ELLIPSOID" -> of(geometry, "ellipsoid").map(each -> vector(each, "radii"))
          .map(r -> new Form(Marker.Type.SPHERE, new Vector3(2 * r.x(), 2 * r.y(), 2 * r.z()), ""));
      case "CYLINDER" -> of(geometry, "cylinder").map(each -> new Form(Marker.Type.CYLINDER,
          round(each, SceneFields.number(each, "length"), false), ""));
      case "CAPSULE" -> of(geometry, "capsule").map(each -> new Form(Marker.Type.CYLINDER,
          round(each, SceneFields.number(each, "length") + 2 * SceneFields.number(each, "radius"), false), ""));
      case "PLANE" -> of(geometry, "plane").map(each -> vector(each, "size"))
          .map(size -> new Form(Marker.Type.CUBE, new Vector3(size.x(), size.y(), FLAT), ""));
      case "MESH" -> of(geometry, "mesh").map(each -> new Form(Marker.Type.MESH, scale(each),
          SceneFields.text(each, "filename")));
      default -> Optional.empty();
    });
  }

  private static Optional<DynamicRecord> of(DynamicRecord geometry, String name) {
    return SceneFields.inner(geometry, name);
  }

  private static Vector3 round(DynamicRecord form, double height, boolean sphere) {
    double wide = 2 * SceneFields.number(form, "radius");
    return new Vector3(wide, wide, sphere ? wide : height);
  }

  private static Vector3 scale(DynamicRecord mesh) {
    return SceneFields.inner(mesh, "scale").isPresent() ? vector(mesh, "scale") : new Vector3(1, 1, 1);
  }

  private static Vector3 vector(DynamicRecord record, String name) {
    DynamicRecord v = SceneFields.inner(record, name).orElse(SceneFields.NOTHING);
    return new Vector3(SceneFields.number(v, "x"), SceneFields.number(v, "y"), SceneFields.number(v, "z"));
  }

  private static RigidTransform pose(DynamicRecord visual) {
    DynamicRecord pose = SceneFields.inner(visual, "pose").orElse(SceneFields.NOTHING);
    DynamicRecord q = SceneFields.inner(pose, "orientation").orElse(SceneFields.NOTHING);
    Quaternion rotation = new Quaternion(SceneFields.number(q, "x"), SceneFields.number(q, "y"),
        SceneFields.number(q, "z"), SceneFields.number(q, "w"));
    boolean none = rotation.equals(new Quaternion(0, 0, 0, 0));
    return new RigidTransform(vector(pose, "position"), none ? Quaternion.IDENTITY : rotation);
  }

  private static Color color(DynamicRecord visual) {
    double seen = 1 - SceneFields.number(visual, "transparency");
    return SceneFields.inner(visual, "material").flatMap(material -> SceneFields.inner(material, "diffuse"))
        .map(c -> new Color((float) SceneFields.number(c, "r"), (float) SceneFields.number(c, "g"),
            (float) SceneFields.number(c, "b"), (float) (SceneFields.number(c, "a") * seen)))
        .orElse(GREY);
  }
}
