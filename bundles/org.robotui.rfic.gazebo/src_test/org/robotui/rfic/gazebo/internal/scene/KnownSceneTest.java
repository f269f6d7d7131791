package org.robotui.rfic.gazebo.internal.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.marker.Marker;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.gazebo.types.GazeboTypes;
import org.robotui.geometry.Vector3;
import org.robotui.message.data.GazeboPoses;
import org.robotui.message.data.GazeboPoses.Frames;
import org.robotui.message.data.GazeboPoses.Subject;
import org.robotui.message.payload.protobuf.NumberedFormat;
import org.robotui.message.payload.protobuf.ProtobufFormat;

/** A rover with a laser and a crate that stands still, as messages say it. */
class KnownSceneTest {
  private static final GazeboTypes TYPES = GazeboTypes.of(Map.of());
  private static final Map<String, Object> BOX =
      Map.of("name", "body", "geometry", Map.of("type", "BOX", "box", Map.of("size", Map.of("x", 1, "y", 2, "z", 3))));
  private static final Map<String, Object> BALL = Map.of("name", "ball", "pose", Map.of("position", Map.of("x", 5)),
      "geometry", Map.of("type", "SPHERE", "sphere", Map.of("radius", 0.5)));

  private final KnownScene scene = new KnownScene();

  private static ProtobufFormat format(String type) {
    return new ProtobufFormat(TYPES.find("gz.msgs." + type).orElseThrow());
  }

  private static DynamicRecord record(String type, Map<String, Object> fields) {
    ProtobufFormat format = format(type);
    return format.read(format.write(fields));
  }

  private void take() {
    Map<String, Object> rover = Map.of("name", "rover", "id", 4, "link", List.of(Map.of("name", "chassis", "id", 5,
        "visual", List.of(BOX, BALL, Map.of("name", "nothing")), "sensor", List.of(Map.of("name", "laser", "id", 7)))));
    Map<String, Object> crate = Map.of("name", "crate", "id", 8, "is_static", true, "link",
        List.of(Map.of("name", "wood", "id", 9)));
    scene.take("yard", record("Scene", Map.of("model", List.of(rover, crate, Map.of("id", 10)))));
  }

  @Test
  void whatStandsThereHasFrames() {
    assertTrue(scene.frames(new Subject(5, "chassis")).isEmpty());
    assertTrue(scene.takeAsked());
    take();
    assertEquals(1, scene.changes());
    assertEquals(Optional.of(new Frames("yard", "rover")), scene.frames(new Subject(4, "rover")));
    assertEquals(Optional.of(new Frames("rover", "rover::chassis")), scene.frames(new Subject(5, "")));
    assertEquals(Optional.of(new Frames("rover::chassis", "rover::chassis::laser")), scene.frames(new Subject(7, "")));
    assertTrue(!scene.takeAsked());
    assertEquals(List.of("rover::chassis::laser", "crate", "crate::wood"),
        scene.transforms(true).stream().map(each -> each.childFrameId()).toList());
    assertEquals(List.of("rover", "rover::chassis"),
        scene.transforms(false).stream().map(each -> each.childFrameId()).toList());
  }

  @Test
  void whatStandsThereHasLooks() {
    take();
    List<Marker> markers =
        SceneMarkers.of("robby", scene).entries().stream().map(e -> e.marker().orElseThrow()).toList();
    assertEquals(List.of(Marker.Type.CUBE, Marker.Type.SPHERE), markers.stream().map(Marker::type).toList());
    assertEquals(new Vector3(1, 2, 3), markers.getFirst().scale());
    assertEquals(new Vector3(5, 0, 0), markers.getLast().pose().translation());
    assertEquals("rover::chassis", markers.getFirst().frame().name());
  }

  @Test
  void aSceneHasSoManyLooksAtMost() {
    Map<String, Object> link = Map.of("name", "chassis", "id", 5, "visual", List.of(BALL));
    Map<String, Object> heap = Map.of("name", "heap", "id", 4, "visual", Collections.nCopies(20_001, BOX), "link",
        List.of(link));
    scene.take("yard", record("Scene", Map.of("model", List.of(heap))));
    assertEquals(20_000, SceneMarkers.of("robby", scene).entries().size());
  }

  @Test
  void posesNameTheirFramesOrSomethingInTheScene() {
    take();
    Map<String, Object> named = Map.of("header", Map.of("data", List.of(Map.of("key", "frame_id", "value",
        List.of("a")), Map.of("key", "child_frame_id", "value", List.of("b")))), "position", Map.of("x", 2));
    DynamicRecord poses = record("Pose_V", Map.of("header", Map.of("stamp", Map.of("sec", 3)), "pose",
        List.of(named, Map.of("id", 4, "name", "rover"), Map.of("id", 99, "name", "stranger"))));
    List<Frames> frames = GazeboPoses.message(poses, scene::frames).transforms().stream()
        .map(each -> new Frames(each.header().frameId(), each.childFrameId())).toList();
    assertEquals(List.of(new Frames("a", "b"), new Frames("yard", "rover")), frames);
    assertEquals(3_000_000_000L,
        GazeboPoses.message(poses, scene::frames).transforms().getFirst().header().stamp());
  }

  @Test
  void anUnknownTypeIsShownByNumbers() {
    DynamicRecord shown = new NumberedFormat("my.Type", "not known")
        .read(format("NavSat").write(Map.of("latitude_deg", 1.5, "frame_id", "gps")));
    assertEquals(List.of("2", "8"), shown.fields());
    assertEquals(Optional.of(new FieldValue.Num(1.5, "1.5")), shown.field("2"));
    assertEquals(Optional.of(new FieldValue.Text("gps")), shown.field("8"));
  }
}
