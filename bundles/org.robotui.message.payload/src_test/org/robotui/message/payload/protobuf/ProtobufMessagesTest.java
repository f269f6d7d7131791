package org.robotui.message.payload.protobuf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.protobuf.DescriptorProtos.DescriptorProto;
import com.google.protobuf.DescriptorProtos.EnumDescriptorProto;
import com.google.protobuf.DescriptorProtos.EnumValueDescriptorProto;
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto;
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto.Label;
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto.Type;
import com.google.protobuf.DescriptorProtos.FileDescriptorProto;
import com.google.protobuf.DescriptorProtos.FileDescriptorSet;
import com.google.protobuf.Descriptors.Descriptor;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;

class ProtobufMessagesTest {
  private static final byte[] DESCRIPTORS = files().toByteArray();
  private static final Descriptor NODE =
      DescriptorSet.message(Base64.getEncoder().encodeToString(DESCRIPTORS), "a.Node");

  private static FileDescriptorSet files() {
    DescriptorProto.Builder node = DescriptorProto.newBuilder().setName("Node");
    Object[][] fields = {{"word", Type.TYPE_STRING, Label.LABEL_OPTIONAL, ""},
        {"big", Type.TYPE_UINT64, Label.LABEL_OPTIONAL, ""}, {"raw", Type.TYPE_BYTES, Label.LABEL_OPTIONAL, ""},
        {"mood", Type.TYPE_ENUM, Label.LABEL_OPTIONAL, ".a.Mood"},
        {"children", Type.TYPE_MESSAGE, Label.LABEL_REPEATED, ".a.Node"},
        {"first", Type.TYPE_MESSAGE, Label.LABEL_OPTIONAL, ".a.Node"},
        {"many", Type.TYPE_FLOAT, Label.LABEL_REPEATED, ""}, {"sure", Type.TYPE_BOOL, Label.LABEL_OPTIONAL, ""},
        {"at", Type.TYPE_MESSAGE, Label.LABEL_OPTIONAL, ".google.protobuf.Timestamp"}};
    for (int i = 0; i < fields.length; i++) {
      FieldDescriptorProto.Builder field = FieldDescriptorProto.newBuilder().setNumber(i + 1)
          .setName((String) fields[i][0]).setType((Type) fields[i][1]).setLabel((Label) fields[i][2]);
      node.addField(fields[i][3].equals("") ? field : field.setTypeName((String) fields[i][3]));
    }
    EnumDescriptorProto mood = EnumDescriptorProto.newBuilder().setName("Mood")
        .addValue(EnumValueDescriptorProto.newBuilder().setName("CALM").setNumber(0))
        .addValue(EnumValueDescriptorProto.newBuilder().setName("ANGRY").setNumber(3)).build();
    return FileDescriptorSet.newBuilder().addFile(FileDescriptorProto.newBuilder().setName("a.proto").setPackage("a")
        .setSyntax("proto3").addDependency("google/protobuf/timestamp.proto").addMessageType(node).addEnumType(mood))
        .build();
  }

  private static ByteBuffer message() {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("word", "hello");
    fields.put("big", "18446744073709551615");
    fields.put("raw", "AQL/");
    fields.put("mood", "ANGRY");
    fields.put("children", List.of(Map.of("word", "child"), Map.of()));
    fields.put("many", List.of(1.5, "2.5"));
    fields.put("at", 1_500_000_000L);
    return ProtobufMessages.write(NODE, fields);
  }

  @Test
  void aMessageIsARecord() {
    ProtobufRecord record = ProtobufMessages.read(NODE, message());
    assertEquals("a.Node", record.schema());
    assertEquals(new FieldValue.Text("hello"), record.field("word").orElseThrow());
    assertEquals("18446744073709551615", ((FieldValue.Num) record.field("big").orElseThrow()).exact());
    assertEquals(Bytes.of((byte) 1, (byte) 2, (byte) -1), record.bytes("raw").orElseThrow());
    assertEquals(new FieldValue.Text("ANGRY"), record.field("mood").orElseThrow());
    assertEquals(new FieldValue.Text("child"), record.at(FieldPath.parse("children[0].word")).orElseThrow());
    assertEquals(2.5, ((FieldValue.Num) record.at(FieldPath.parse("many[1]")).orElseThrow()).value());
    assertEquals(new FieldValue.Time(1_500_000_000L), record.field("at").orElseThrow());
    assertEquals(new FieldValue.Flag(false), record.field("sure").orElseThrow());
    assertTrue(record.field("first").isEmpty(), "a message that is not set has no value");
  }

  @Test
  void theFormOfATypeThatContainsItselfEnds() {
    FieldShape.Nested first =
        (FieldShape.Nested) ProtobufShapes.of(NODE).field("first").orElseThrow().shape();
    assertTrue(first.shape().fields().isEmpty());
    assertEquals(new FieldShape.Time(), ProtobufShapes.of(NODE).field("at").orElseThrow().shape());
  }

  @Test
  void whatDoesNotFitIsRefusedByName() {
    for (Map<String, Object> each : List.<Map<String, Object>>of(Map.of("none", 1), Map.of("mood", "GLAD"),
        Map.of("big", "x"), Map.of("first", "x"), Map.of("many", 3))) {
      assertThrows(IllegalArgumentException.class, () -> ProtobufMessages.write(NODE, each), each.toString());
    }
  }

  @Test
  void aMessageThatWouldGrowWhenItIsReadIsRefused() {
    byte[] empty = new byte[6_000_000];
    for (int i = 0; i < empty.length; i += 2) {
      empty[i] = 5 << 3 | 2; // a child without anything in it
    }
    IllegalArgumentException refusal =
        assertThrows(IllegalArgumentException.class, () -> ProtobufMessages.read(NODE, ByteBuffer.wrap(empty)));
    assertTrue(refusal.getMessage().contains("values"), refusal.getMessage());
  }

  @Test
  void damagedMessagesAndDescriptorsAreRefusedAndNothingElse() {
    Random random = new Random(9);
    byte[] good = new byte[message().remaining()];
    message().get(good);
    int refused = 0;
    for (int i = 0; i < 20_000; i++) {
      try {
        ProtobufRecord record = ProtobufMessages.read(NODE, ByteBuffer.wrap(damaged(good, random)));
        record.fields().forEach(record::field);
      } catch (IllegalArgumentException e) {
        refused++;
      }
      try {
        ProtobufShapes.of(DescriptorSet.message(Base64.getEncoder().encodeToString(damaged(DESCRIPTORS, random)),
            "a.Node"));
      } catch (IllegalArgumentException e) {
        refused++;
      }
    }
    assertTrue(refused > 10_000, "only " + refused);
  }

  private static byte[] damaged(byte[] good, Random random) {
    byte[] bad = good.clone();
    bad[random.nextInt(bad.length)] = (byte) random.nextInt();
    return random.nextInt(4) == 0 ? Arrays.copyOf(bad, random.nextInt(bad.length)) : bad;
  }
}
