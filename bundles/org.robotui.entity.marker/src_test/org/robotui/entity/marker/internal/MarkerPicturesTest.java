package org.robotui.entity.marker.internal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.command.CommandOutcome;
import org.robotui.data.Data;
import org.robotui.data.marker.Color;
import org.robotui.data.marker.InteractiveMarker;
import org.robotui.data.marker.InteractiveMarker.Control;
import org.robotui.data.marker.InteractiveMarker.Mode;
import org.robotui.data.marker.InteractiveMarker.Orientation;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.data.marker.Marker.Type;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;

/** How markers look. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class MarkerPicturesTest {
  private static final DisplayContext CONTEXT = new DisplayContext() {
    @Override
    public Executor background() {
      return Runnable::run;
    }

    @Override
    public void wake() {
      // one picture only
    }

    @Override
    public CommandOutcome send(Data command) {
      return new CommandOutcome.Accepted();
    }
  };
  @AutoClose
  private static final ScenePictures PICTURES = new ScenePictures();

  private static Sample at(int id, Type type, double x, double y) {
    return Sample.of(id, type).at(x, y, 0, Quaternion.IDENTITY).scale(0.7, 0.7, 0.7);
  }

  private static List<Part> everyType() {
    float[] way = {0, -0.3f, 0, 0.3f, 0.3f, 0, -0.3f, 0.3f, 0.3f, 0.3f, -0.3f, 0.5f};
    float[] dots = {-0.3f, -0.3f, 0, 0.3f, -0.3f, 0, 0, 0.3f, 0, 0, 0, 0.4f};
    Ticks scene = new Ticks(MarkersType.SCHEMA);
    MarkersDisplay display = new MarkersDisplay(CONTEXT);
    List<Part> parts = new ArrayList<>(display.update(scene.of(Sample.set(scene.now,
        at(1, Type.ARROW, 0, 0).scale(0.8, 0.15, 0.15), at(2, Type.CUBE, 0, 1), at(3, Type.SPHERE, 0, 2),
        at(4, Type.CYLINDER, 0, 3),
        at(5, Type.LINE_STRIP, 1, 0).scale(0.01, 0, 0).points(way),
        at(6, Type.LINE_LIST, 1, 1).scale(0.06, 0, 0).points(way),
        at(7, Type.CUBE_LIST, 1, 2).scale(0.2, 0.2, 0.2).points(dots),
        at(8, Type.SPHERE_LIST, 1, 3).scale(0.2, 0.2, 0.2).points(dots),
        at(9, Type.POINTS, 2, 0).scale(0.1, 0.1, 0).points(dots),
        at(10, Type.TEXT, 2, 1).scale(0, 0, 0.4).saying("text"),
        at(11, Type.TRIANGLE_LIST, 2, 2).scale(1, 1, 1).points(-0.4f, -0.4f, 0, 0.4f, -0.4f, 0, 0, 0.4f, 0.4f),
        at(12, Type.ARROW, 2, 3).scale(0.1, 0.25, 0.3).points(-0.3f, 0, 0, 0.4f, 0, 0.6f)))).parts());
    display.close();
    return parts;
  }

  @Test
  void everyTypeOfMarker() {
    PICTURES.assertLike(MarkerPicturesTest.class, "every-type",
        ScenePictures.request(everyType(), ScenePictures.eye(new Vector3(-2.2, 1.5, 3), new Vector3(1, 1.5, 0))));
  }

  /** A roof, with its own colours and with that of its marker. */
  @Test
  void meshesOfAPackage(@TempDir Path folder) throws IOException {
    Files.createDirectories(folder.resolve("p"));
    Files.writeString(folder.resolve("p/package.xml"), "<package><name>p</name></package>");
    Files.writeString(folder.resolve("p/roof.obj"), """
        mtllib roof.mtl
        v -0.4 -0.4 0
        v 0.4 -0.4 0
        v 0.4 0.4 0
        v -0.4 0.4 0
        v 0 -0.4 0.5
        v 0 0.4 0.5
        usemtl left
        f 1 5 6 4
        usemtl right
        f 2 3 6 5
        usemtl gable
        f 1 2 5
        f 3 4 6
        """);
    Files.writeString(folder.resolve("p/roof.mtl"),
        "newmtl left\nKd 0.2 0.6 0.9\nnewmtl right\nKd 0.9 0.7 0.2\nnewmtl gable\nKd 0.4 0.8 0.4\n");
    Ticks scene = new Ticks(MarkersType.SCHEMA);
    scene.values.put(MarkersType.PACKAGES, List.of(folder.toString()));
    MarkersDisplay display = new MarkersDisplay(CONTEXT);
    Sample roof = Sample.of(1, Type.MESH).mesh("package://p/roof.obj");
    Sample own = Sample.of(2, Type.MESH).at(0, 0.6, 0, Quaternion.IDENTITY).scale(1, 1, 1.6)
        .mesh("package://p/roof.obj").withMaterials();
    display.update(
        scene.of(Sample.set(scene.now, roof.at(0, -0.6, 0, Quaternion.IDENTITY), own.colored(new Color(1, 1, 1, 1)))));
    List<Part> parts = display.update(scene.of()).parts();
    display.close();
    PICTURES.assertLike(MarkerPicturesTest.class, "meshes",
        ScenePictures.request(parts, ScenePictures.eye(new Vector3(-0.9, -1.7, 1.5), new Vector3(0, 0, 0.2))));
  }

  private static Control control(Mode mode, Quaternion turn) {
    return new Control(mode + " " + turn, "", mode, Orientation.INHERIT, turn, true, List.of(), false);
  }

  @Test
  void theUsualLookOfAnInteractiveMarker() {
    double half = Math.sqrt(0.5);
    Quaternion up = new Quaternion(0, -half, 0, half);
    InteractiveMarker marker = new InteractiveMarker("goal", "a goal", "", Ticks.frame("map"), Optional.empty(),
        RigidTransform.IDENTITY, 1, List.of(),
        List.of(control(Mode.MOVE_AXIS, Quaternion.IDENTITY), control(Mode.MOVE_AXIS, Quaternion.fromYaw(Math.PI / 2)),
            control(Mode.MOVE_AXIS, up), control(Mode.ROTATE_AXIS, up), control(Mode.BUTTON, Quaternion.IDENTITY)));
    Ticks scene = new Ticks(InteractiveType.SCHEMA);
    InteractiveMarkerSet set =
        new InteractiveMarkerSet(true, List.of(new InteractiveMarkerSet.Entry("goal", Optional.of(marker))));
    InteractiveDisplay display = new InteractiveDisplay(CONTEXT);
    List<Part> parts = display.update(scene.of(set)).parts();
    display.close();
    PICTURES.assertLike(MarkerPicturesTest.class, "interactive",
        ScenePictures.request(parts, ScenePictures.eye(new Vector3(-1.6, -1.2, 1.4), Vector3.ZERO),
            ScenePictures.LIGHT));
  }
}
