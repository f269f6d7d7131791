package org.robotui.message.recorded;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

import org.junit.jupiter.api.Test;
import org.robotui.message.AnyCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageException;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageWriter;
import org.robotui.message.RecordCodec;
import org.robotui.message.RosValue;
import org.robotui.message.ShippedRecords;
import org.robotui.message.ros.nav_msgs.OccupancyGrid;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.sensor_msgs.CameraInfo;
import org.robotui.message.ros.sensor_msgs.CompressedImage;
import org.robotui.message.ros.sensor_msgs.LaserScan;

/** Real recordings: every message is decoded by both codecs, and the values are those the data set's page names. */
class RecordedMessagesTest {

  /** The markers of marker_cube.bag are of an early version, which only the definition that came with them can read. */
  private static final String OLDER = "18326976df9d29249efc939e00342cde";

  private final Map<String, Optional<RecordCodec<?>>> codecs = new HashMap<>();
  private final AnyCodec any = new AnyCodec(new MessageRegistry(new LocalDefinitions(List.of(), List.of())));

  private static List<BagReader.Recorded> on(String topic, List<BagReader.Recorded> messages) {
    return messages.stream().filter(m -> m.topic().equals(topic)).toList();
  }

  private Map<String, Integer> decodeAll(Path bag) throws MessageException, IOException {
    Map<String, Integer> counts = new TreeMap<>();
    for (BagReader.Recorded each : BagReader.read(bag)) {
      DynamicMessage dynamic = any.decode(each.bytes().duplicate(), each.info());
      assertEquals(each.info().type(), dynamic.type());
      Optional<RecordCodec<?>> compiled = codec(each.info().type());
      if (compiled.isPresent() && !OLDER.equals(each.info().md5())) {
        assertEquals(each.info().md5(), compiled.get().info().md5());
        assertArrayEquals(array(each.bytes()), reencode(compiled.get(), each.bytes()));
      }
      counts.merge(each.topic(), 1, Integer::sum);
    }
    return counts;
  }

  private Optional<RecordCodec<?>> codec(String type) throws IOException {
    if (!codecs.containsKey(type)) {
      codecs.put(type, ShippedRecords.codec(type));
    }
    return codecs.get(type);
  }

  private static <T extends Record> byte[] reencode(RecordCodec<T> codec, ByteBuffer bytes) throws MessageException {
    MessageWriter out = new MessageWriter();
    codec.encode(codec.decode(bytes.duplicate()), out);
    return out.toByteArray();
  }

  private static byte[] array(ByteBuffer buffer) {
    byte[] bytes = new byte[buffer.remaining()];
    buffer.duplicate().get(bytes);
    return bytes;
  }

  @Test
  void aMobileRobotsRecordingIsReadCompletely() throws Exception {
    assertEquals(Map.of("/scan", 224, "/odom", 224, "/tf", 448, "/tf_static", 1, "/map", 1),
        decodeAll(SharedData.bag("sena_loop.bag")));
  }

  @Test
  void typesThatNoClientHasBuiltInAreReadByTheirDefinition() throws Exception {
    Path bag = SharedData.bag("turtlesim.bag");
    assertEquals(Map.of("/turtle1/pose", 1344, "/turtle2/pose", 1344, "/turtle1/color_sensor", 1351,
        "/turtle2/color_sensor", 1344, "/turtle1/cmd_vel", 357, "/turtle2/cmd_vel", 208, "/tf", 2688,
        "/tf_static", 1, "/rosout", 10), decodeAll(bag));
    BagReader.Recorded pose = on("/turtle1/pose", BagReader.read(bag)).getFirst();
    DynamicMessage message = any.decode(pose.bytes(), pose.info());
    assertEquals(5.544, message.number("x").orElseThrow(), 1e-3);
  }

  @Test
  void imagesAndMarkersAreRead() throws Exception {
    assertEquals(16, decodeAll(SharedData.bag("stereo_jpeg.bag")).values().stream().mapToInt(i -> i).sum());
    Path cube = SharedData.bag("marker_cube.bag");
    assertEquals(Map.of("/marker_in_parent_frame", 1, "/tf", 1), decodeAll(cube));
    BagReader.Recorded marker = on("/marker_in_parent_frame", BagReader.read(cube)).getFirst();
    DynamicMessage message = any.decode(marker.bytes(), marker.info());
    assertEquals(0.5, message.number("color.a").orElseThrow());
    assertEquals("parent_frame", message.text("header.frame_id").orElseThrow());
  }

  @Test
  void theValuesOfTheMobileRobotAreThoseOfItsPage() throws Exception {
    List<BagReader.Recorded> messages = BagReader.read(SharedData.bag("sena_loop.bag"));
    LaserScan scan = RecordCodec.of(LaserScan.class).decode(on("/scan", messages).getFirst().bytes());
    assertEquals(361, scan.ranges().length);
    assertEquals(6.96f, scan.ranges()[180], 0.005f);
    assertEquals("laser", scan.header().frameId());
    Odometry last = RecordCodec.of(Odometry.class).decode(on("/odom", messages).getLast().bytes());
    assertEquals(-4.802438, last.pose().pose().position().x(), 1e-6);
    OccupancyGrid map = RecordCodec.of(OccupancyGrid.class).decode(on("/map", messages).getFirst().bytes());
    assertEquals(651 * 717, map.data().remaining());
    assertEquals(321479, count(map.data(), (byte) -1));
    assertEquals(-43.536954, map.info().origin().position().y(), 1e-6);
  }

  private static int count(ByteBuffer cells, byte value) {
    int count = 0;
    while (cells.hasRemaining()) {
      count += cells.get() == value ? 1 : 0;
    }
    return count;
  }

  @Test
  void imageBytesAreNotCopied() throws Exception {
    List<BagReader.Recorded> messages = BagReader.read(SharedData.bag("stereo_jpeg.bag"));
    ByteBuffer frame = on("/stereo/left/image_raw/compressed", messages).getFirst().bytes();
    CompressedImage image = RecordCodec.of(CompressedImage.class).decode(frame.duplicate());
    assertEquals((byte) 0xff, image.data().get(0));
    int start = frame.remaining() - image.data().remaining();
    frame.put(start, (byte) 1);
    assertEquals(1, image.data().get(0), "the slice shows the frame's memory");
    BagReader.Recorded info = on("/stereo/left/camera_info", messages).getFirst();
    assertEquals(835.757, RecordCodec.of(CameraInfo.class).decode(info.bytes()).k()[0], 1e-3);
    RosValue k = any.decode(info.bytes(), info.info()).at("K[4]").orElseThrow();
    assertTrue(k instanceof RosValue.Real real && Math.abs(real.value() - 838.058) < 1e-3);
  }
}
