package org.robotui.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.invoke.MethodHandles;
import java.nio.ByteBuffer;
import java.util.List;
import org.junit.jupiter.api.Test;

class VersionTolerantCodecTest {

  private static final String PARTS = """
      ================================================================================
      MSG: lab_msgs/Part
      """;
  private static final String NEW = "string name\nfloat64 weight\nPart[] parts\nint32[3] code\nbool checked\n" + PARTS
      + "uint8 kind\nstring label\n";
  private static final String OLD =
      "float64 weight\nint16 gone\nPart[] parts\nstring name\n" + PARTS + "string label\nfloat32 old\n";

  private final MessageRegistry registry = new MessageRegistry(new LocalDefinitions(List.of(), List.of()));

  private static MessageSchema schema(String definition) throws DefinitionException {
    return MessageSchema.parse("lab_msgs/Box", definition);
  }

  private record Part(int kind, String label) {}

  private record Box(String name, double weight, List<Part> parts, int[] code, boolean checked) {}

  private VersionTolerantCodec<Box> ours() throws DefinitionException {
    return new VersionTolerantCodec<>(RecordCodec.of(Box.class, schema(NEW), MethodHandles.lookup()), registry);
  }

  private static ByteBuffer old() {
    MessageWriter out = new MessageWriter();
    out.f64(2.5).i16(7).i32(2);
    out.string("lid").f32(1);
    out.string("bottom").f32(2);
    out.string("crate");
    return ByteBuffer.wrap(out.toByteArray());
  }

  @Test
  void anOlderVersionIsReadByTheNamesOfItsFields() throws Exception {
    Box box = ours().decode(old(), schema(OLD).info());
    assertEquals("crate", box.name());
    assertEquals(2.5, box.weight());
    assertEquals(List.of(new Part(0, "lid"), new Part(0, "bottom")), box.parts());
    assertEquals(3, box.code().length);
    assertFalse(box.checked());
  }

  @Test
  void anyVersionIsAskedFor() throws Exception {
    MessageInfo info = ours().info();
    assertEquals("lab_msgs/Box", info.type());
    assertTrue(info.accepts(schema(OLD).info().md5()));
  }

  @Test
  void aFieldThatIsSomethingElseIsNamed() throws Exception {
    MessageInfo other = schema("float32 weight\n").info();
    ByteBuffer bytes = ByteBuffer.wrap(new byte[4]);
    MessageException e = assertThrows(MessageException.class,
        () -> ours().decode(bytes, other));
    assertTrue(e.getMessage().contains("weight"), e.getMessage());
  }

  @Test
  void anotherTypeAndOneWithNothingInCommonAreRefused() throws Exception {
    VersionTolerantCodec<Box> codec = ours();
    MessageInfo stranger = schema("int8 x\n").info();
    assertThrows(MessageException.class, () -> codec.decode(ByteBuffer.wrap(new byte[1]), stranger));
    MessageInfo elsewhere = MessageSchema.parse("lab_msgs/Cup", OLD).info();
    assertThrows(MessageException.class, () -> codec.decode(old(), elsewhere));
  }

  @Test
  void damagedBytesOfAnOlderVersionAreRefusedWhereverTheyEnd() throws Exception {
    VersionTolerantCodec<Box> codec = ours();
    MessageInfo info = schema(OLD).info();
    for (int length = 0; length < old().limit(); length++) {
      ByteBuffer cut = old().slice(0, length);
      assertThrows(MessageException.class, () -> codec.decode(cut, info));
    }
  }
}
