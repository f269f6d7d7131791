package org.robotui.rfic.player.internal.convert;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.RecordShape;
import org.robotui.player.layout.InterfaceLayout;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.PlayerRecord;
import org.robotui.player.layout.StructLayout;

class RecordsTest {
  private final Layouts layouts = Layouts.standard();

  private StructLayout struct(String name, String struct) {
    return layouts.byName(name).map(InterfaceLayout::structs).orElseThrow().get(struct);
  }

  @Test
  void everyKindOfFieldIsRead() {
    PlayerRecord body = PlayerRecord.of(struct("blobfinder", "blobs"),
        Map.of("width", 80, "blobs", List.of(Map.of("id", 7, "range", 1.5))));
    RecordView view = new RecordView("blobfinder/blobs", body);
    assertEquals(List.of("width", "height", "blobs"), view.fields());
    assertEquals(Optional.of(new FieldValue.Num(80, "80")), view.field("width"));
    assertEquals(1.5, ((FieldValue.Num) view.at(FieldPath.parse("blobs[0].range")).orElseThrow()).value());
    RecordView text = new RecordView("t", PlayerRecord.of(struct("speech", "text"), Map.of("text", "hello")));
    assertEquals(Optional.of(new FieldValue.Text("hello")), text.field("text"));
    RecordView bytes = new RecordView("b", PlayerRecord.of(struct("opaque", "bytes"), Map.of("data", List.of(1, 255))));
    assertEquals(255, ((FieldValue.Numbers) bytes.field("data").orElseThrow()).values().get(1));
    RecordView flag = new RecordView("f", PlayerRecord.of(struct("position2d", "switch"), Map.of("on", true)));
    assertEquals(Optional.of(new FieldValue.Flag(true)), flag.field("on"));
  }

  @Test
  void formsHaveTheTypesOfTheWire() {
    RecordShape shape = PlayerShapes.of(Optional.of(struct("localize", "estimate")));
    assertEquals(new FieldShape.Many(new FieldShape.Real(64), 6), shape.field("covariance").orElseThrow().shape());
    assertTrue(PlayerShapes.of(Optional.empty()).fields().isEmpty());
    assertEquals(new FieldShape.Many(new FieldShape.Whole(8, false), 0),
        PlayerShapes.of(Optional.of(struct("opaque", "bytes"))).field("data").orElseThrow().shape());
  }

  @Test
  void everyStructureHasAFormAndAText() {
    layouts.all().forEach(i -> i.structs().values().forEach(s -> {
      assertEquals(s.fields().size(), PlayerShapes.of(Optional.of(s)).fields().size(), s.name());
      s.fields().forEach(f -> assertTrue(PlayerShapes.text(Optional.of(s)).contains(" " + f.name()), f.name()));
    }));
    assertTrue(PlayerShapes.text(Optional.of(struct("gps", "state"))).contains("altitude [mm]"));
  }
}
