package org.robotui.core.internal.port;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.core.internal.support.Samples;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.sensor.Battery;
import org.robotui.data.status.Diagnostics;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

class ValueTextTest {
  private static final FrameId FRAME = new FrameId("r", "map");

  private record Record(Map<String, FieldValue> values) implements DynamicRecord {
    @Override
    public String schema() {
      return "my_msgs/Thing";
    }

    @Override
    public List<String> fields() {
      return List.copyOf(values.keySet());
    }

    @Override
    public Optional<FieldValue> field(String name) {
      return Optional.ofNullable(values.get(name));
    }
  }

  @Test
  void printsWhatMattersOfEachType() {
    assertEquals("1 beams, min 0.42 m", ValueText.of(Samples.scan(0.42f)));
    assertEquals("1 beams, no echo", ValueText.of(Samples.scan(Float.POSITIVE_INFINITY)));
    RigidTransform pose = RigidTransform.planar(1.2, -0.3, Math.toRadians(12));
    assertEquals("x 1.20 y −0.30 m 12°", ValueText.of(new PoseEstimate(FRAME, pose, Doubles.EMPTY)));
    assertEquals("−0.50 m/s 1.00 rad/s", ValueText.of(VelocityCommand.planar(-0.5, 1)));
    assertEquals("87 % 14.1 V", ValueText.of(new Battery(14.1, 0, 0.87, Battery.Status.UNKNOWN)));
    assertEquals("34 poses", ValueText.of(new Path(FRAME, Collections.nCopies(34, RigidTransform.IDENTITY))));
    assertEquals("2x1 cells, 0.05 m", ValueText.of(
        new GridMap(FRAME, 0.05, 2, 1, RigidTransform.IDENTITY, Bytes.of((byte) 0, (byte) 1))));
    List<Vector3> corners = List.of(new Vector3(0, 0, 0), new Vector3(1, 0, 0), new Vector3(0, 1, 0));
    assertEquals("3 corners", ValueText.of(new Footprint(FRAME, corners)));
    assertEquals("INFO node: hello", ValueText.of(Samples.log("hello")));
  }

  @Test
  void printsImagesByTheirFormat() {
    PixelEncoding encoding = PixelEncoding.values()[0];
    int step = 2 * encoding.bytesPerPixel();
    RawImage image = new RawImage(FRAME, 2, 1, encoding, false, step, Bytes.of(new byte[step]));
    assertEquals("2x1 " + encoding.name().toLowerCase(Locale.ROOT), ValueText.of(image));
  }

  @Test
  void printsTheFirstPlainFieldsOfUnknownTypes() {
    Map<String, FieldValue> values = new LinkedHashMap<>();
    values.put("id", new FieldValue.Num(7, "7"));
    values.put("ok", new FieldValue.Flag(true));
    values.put("data", new FieldValue.Numbers(Doubles.of(1, 2)));
    values.put("more", new FieldValue.Num(8, "8"));
    assertEquals("id 7 ok true data [2]", ValueText.of(new Record(values)));
    assertEquals("my_msgs/Thing", ValueText.of(new Record(Map.of())));
  }

  @Test
  void isOneShortLineWhateverTheRobotSends() {
    String text = ValueText.of(Samples.log("a\nb\u001b[31m" + "x".repeat(500)));
    assertTrue(text.length() <= 60 && text.chars().noneMatch(Character::isISOControl), text);
    assertEquals("data '" + "y".repeat(53) + "…",
        ValueText.of(new Record(Map.of("data", new FieldValue.Text("y".repeat(5000))))));
    Diagnostics.Item bad = new Diagnostics.Item("motor", "", Diagnostics.Level.ERROR, "hot", Map.of());
    assertEquals("1 items, 1 not ok: motor hot", ValueText.of(new Diagnostics(List.of(bad))));
  }
}
