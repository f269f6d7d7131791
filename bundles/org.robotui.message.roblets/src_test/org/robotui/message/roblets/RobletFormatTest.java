package org.robotui.message.roblets;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.sensor.GpsFix;
import org.robotui.message.data.Adapter;
import org.robotui.message.data.Adapters;
import org.robotui.message.data.FrameNames;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyForm;
import org.robotui.roblets.wire.BodyDatagram;
import org.robotui.roblets.wire.DatagramKind;

class RobletFormatTest {
  private static final BodyForm POSITION = new BodyForm("position", "gpsfix",
      List.of(new BodyForm.Field("latitude", "number", "deg"), new BodyForm.Field("fix", "flag", "")));
  private static final BodyElement HERE = BodyElement.of("position").with("latitude", 48.5).with("longitude", 11.25);

  private static ByteBuffer datagram(BodyElement said) {
    return ByteBuffer.wrap(new BodyDatagram(DatagramKind.MESSAGE, "gps", 1, 2, 3, "brain", Optional.of(said)).bytes());
  }

  private static RobletFormat format(BodyForm form) {
    return RobletFormat.of(RobletFormat.type("gps", form),
        new String(RobletFormat.definition(form), StandardCharsets.UTF_8));
  }

  /** As the player of recordings does it: by the type to the conversion, by the format to the record. */
  @SuppressWarnings("unchecked") // such messages are read by the names of their fields
  private static Data data(RobletFormat format, BodyElement said) {
    Adapter<DynamicRecord, ?> adapter = (Adapter<DynamicRecord, ?>) new Adapters().ofFields(format.type());
    return adapter.convert().apply(format.read(datagram(said)), new FrameNames("boat", ClockKind.ROBOT)).orElseThrow();
  }

  @Test
  void aWordOfItsFormSaysWhatAMessageIs() {
    RobletFormat format = format(POSITION);
    assertEquals("roblets.gpsfix", format.type());
    GpsFix fix = (GpsFix) data(format, HERE);
    assertEquals(new FrameId("boat", "base_link"), fix.frame());
    assertEquals(Math.toRadians(48.5), fix.latitude(), 1e-12);
    assertEquals(GpsFix.Quality.NO_FIX, ((GpsFix) data(format, HERE.with("fix", "false"))).quality());
    assertEquals(List.of("latitude", "fix"),
        format.shape().orElseThrow().fields().stream().map(field -> field.name()).toList());
  }

  @Test
  void otherMessagesAreRecords() {
    RobletFormat format = format(new BodyForm("odometry", "wheels", List.of()));
    assertEquals("gps.odometry", format.type());
    DynamicRecord read = (DynamicRecord) data(format, HERE);
    assertEquals(11.25, read.number(FieldPath.parse("longitude")).orElseThrow());
  }

  @Test
  void recordingsWithoutFormsAreReadToo() {
    RobletFormat format = RobletFormat.of("", "");
    assertTrue(format.shape().isEmpty());
    assertEquals(48.5, format.read(datagram(HERE)).number(FieldPath.parse("latitude")).orElseThrow());
  }

  @Test
  void whatIsNoDatagramIsRefused() {
    assertThrows(IllegalArgumentException.class,
        () -> format(POSITION).read(ByteBuffer.wrap("<x/>".getBytes(StandardCharsets.UTF_8))));
    String wrong =
        assertThrows(IllegalArgumentException.class, () -> data(format(POSITION), BodyElement.of("position")))
            .getMessage();
    assertEquals("roblets.gpsfix has no finite number 'latitude'", wrong);
  }
}
