package org.robotui.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.PoseWithCovariance;
import org.robotui.message.ros.geometry_msgs.Quaternion;

/** The vectors are the sums that the generated Python classes of the ROS packages carry. */
class WellKnownSumsTest {

  private final ShippedDefinitions shipped = new ShippedDefinitions();

  @Test
  void everyShippedMessageHasTheSumOfTheRealPackage() throws Exception {
    Map<String, String> actual = new TreeMap<>();
    Map<String, String> expected = vectors("md5_messages.txt");
    for (String type : expected.keySet()) {
      actual.put(type, MessageSchema.resolve(shipped.find(type).orElseThrow(), shipped).info().md5());
    }
    assertEquals(expected, actual);
    assertTrue(expected.size() > 150, "the vectors were read");
  }

  @Test
  void everyShippedServiceHasTheSumOfTheRealPackage() throws Exception {
    Map<String, String> actual = new TreeMap<>();
    Map<String, String> expected = vectors("md5_services.txt");
    for (String type : expected.keySet()) {
      actual.put(type, ServiceSchema.resolve(shipped.service(type).orElseThrow(), shipped).md5());
    }
    assertEquals(expected, actual);
  }

  @Test
  void aRecordAnnouncesTheSumOfTheRealPackage() throws Exception {
    Map<String, String> sums = vectors("md5_messages.txt");
    Map<String, RecordCodec<?>> codecs = ShippedRecords.codecs();
    codecs.keySet().retainAll(sums.keySet());
    codecs.forEach((type, codec) -> assertEquals(sums.get(type), codec.info().md5(), type));
    assertTrue(codecs.size() > 70, "the records were found");
  }

  @Test
  void aFixedArrayOfAnotherLengthIsNotWritten() {
    Pose pose = new Pose(new Point(0, 0, 0), new Quaternion(0, 0, 0, 1));
    PoseWithCovariance wrong = new PoseWithCovariance(pose, new double[9]);
    IllegalArgumentException e = assertThrows(IllegalArgumentException.class,
        () -> RecordCodec.of(PoseWithCovariance.class).encode(wrong, new MessageWriter()));
    assertEquals("covariance has 36 values, not 9", e.getMessage());
  }

  static Map<String, String> vectors(String name) throws IOException {
    Map<String, String> sums = new TreeMap<>();
    try (InputStream in = WellKnownSumsTest.class.getResourceAsStream(name)) {
      for (String line : new String(in.readAllBytes(), StandardCharsets.UTF_8).split("\n")) {
        String[] words = line.split(" ");
        sums.put(words[0], words[1]);
      }
    }
    return sums;
  }
}
