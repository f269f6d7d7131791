package org.robotui.uic.scene3d.recorded;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.entity.gridmap.internal.display.GridMapType;
import org.robotui.entity.image.internal.display.CameraType;
import org.robotui.entity.image.internal.display.ImageType;
import org.robotui.entity.laserscan.internal.display.LaserScanType;
import org.robotui.entity.marker.internal.MarkersType;
import org.robotui.entity.odometry.internal.display.OdometryType;
import org.robotui.entity.pointcloud.internal.PointCloudType;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayType;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageException;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageRegistry;
import org.robotui.message.data.Adapter;
import org.robotui.message.data.Adapters;
import org.robotui.message.data.FrameNames;
import org.robotui.rfic.ros.internal.convert.MessageReading;
import org.robotui.rfic.ros.internal.convert.RecordDecoder;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;
import org.robotui.testkit.recorded.BagReader;
import org.robotui.testkit.recorded.BagReader.Recorded;
import org.robotui.testkit.recorded.SharedData;

/** Recordings of real robots, from the bytes of their messages to what is seen. */
@EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
class RecordedDataTest {
  private static final List<DisplayType> TYPES =
      List.of(new LaserScanType(), new PointCloudType(), new GridMapType(), new OdometryType(),
          new MarkersType(), new ImageType(), new CameraType());
  /** Which displays have something to show of a recording; those of no others do. */
  private static final Map<String, List<String>> SHOWN =
      Map.of("sena_loop.bag", List.of("gridmap", "laserscan", "odometry"),
          "husky_imu_gps_odom.bag", List.of("odometry"), "stereo_jpeg.bag", List.of("camera", "image"),
          "lidar_clouds.bag", List.of("pointcloud"),
          "marker_cube.bag", List.of("markers"));
  /** How many messages a recording has, as its page says. */
  private static final Map<String, Integer> MESSAGES =
      Map.of("sena_loop.bag", 898, "husky_imu_gps_odom.bag", 16806, "stereo_jpeg.bag", 16,
          "lidar_clouds.bag", 3, "tiago_joint_states.bag", 8022, "turtlesim.bag", 8647, "turtlesim_bz2.bag", 8647,
          "turtlesim_lz4.bag", 8647,
          "marker_cube.bag", 2, "no_messages.bag", 0);
  private static final FrameNames NAMES = new FrameNames(FakePlaces.ROBOT, ClockKind.ROBOT);

  private static final RecordDecoder RECORDS =
      new RecordDecoder(new MessageRegistry(new LocalDefinitions(List.of(), List.of())));
  private final Adapters adapters = new Adapters();
  private final Map<String, DisplayProbe> probes = new TreeMap<>();
  private final Map<String, DisplayResult> results = new TreeMap<>();

  static List<Path> bags() {
    return SharedData.files("bags", ".bag");
  }

  @ParameterizedTest
  @MethodSource("bags")
  void everyMessageIsShownByTheDisplaysOfItsType(Path bag) throws MessageException {
    List<Recorded> messages = BagReader.read(bag);
    String name = bag.getFileName().toString();
    assertEquals(MESSAGES.get(name), messages.size(), name);
    for (Recorded message : messages) {
      decode(adapters.of(message.type()), message).ifPresent(value -> show(message.topic(), value));
    }
    assertEquals(SHOWN.getOrDefault(name, List.of()), List.copyOf(results.keySet()), name);
    results.forEach(
        (id, result) -> assertTrue(result.parts().size() > 0, () -> name + ", " + id + ": " + result.status().words()));
    look(name);
    probes.values().forEach(DisplayProbe::close);
  }

  private static <M, D extends Data> Optional<D> decode(Adapter<M, D> adapter, Recorded message)
      throws MessageException {
    MessageInfo info = new MessageInfo(message.type(), message.md5(), message.definition());
    return adapter.convert().apply(MessageReading.of(adapter.form(), RECORDS)
        .read(message.bytes().duplicate().order(message.bytes().order()), info), NAMES);
  }

  private void show(String topic, Data value) {
    for (DisplayType type : TYPES) {
      if (type.accepts().stream().anyMatch(accepted -> accepted.isInstance(value))) {
        DisplayResult result = probes.computeIfAbsent(type.id(), id -> probe(type)).tick(value);
        results.put(type.id(), result);
        assertTrue(isGood(result.status()), () -> topic + ": " + result.status());
      }
    }
  }

  /** A camera has to wait for both its picture and its calibration. */
  private static boolean isGood(DisplayStatus status) {
    return status instanceof DisplayStatus.Shown || status instanceof DisplayStatus.Partly
        || status instanceof DisplayStatus.NoData;
  }

  private static DisplayProbe probe(DisplayType type) {
    DisplayProbe probe = new DisplayProbe(type);
    probe.places().knowAll();
    return probe;
  }

  private void look(String name) {
    if (!Displays.available() || results.isEmpty()) {
      return;
    }
    try (ScenePictures pictures = new ScenePictures()) {
      results.forEach((id, result) -> pictures.assertSeen(id + " of " + name, result.parts()));
    }
  }
}
