package org.robotui.ros.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
  private static final String OLD = "float64 weight\nint16 gone\nPart[] parts\nstring name\n" + PARTS + "string label\nfloat32 old\n";

  private final MessageRegistry registry = new MessageRegistry(new LocalDefinitions(List.of(), List.of()));

  private static MessageSchema schema(String definition) throws DefinitionException {
    return MessageSchema.parse("lab_msgs/Box", definition);
  }

  /** Our version, as a codec of dynamic messages. */
  private MessageCodec<DynamicMessage> ours() throws DefinitionException {
    MessageSchema schema = schema(NEW);
    return new MessageCodec<>() {
      @Override
      public MessageInfo info() {
        return schema.info();
      }

      @Override
      public DynamicMessage decode(ByteBuffer in) throws MessageException {
        return DynamicMessage.check(schema.layout(), in);
      }

      @Override
      public void encode(DynamicMessage value, MessageWriter out) {
        out.bytes(value.bytes());
      }
    };
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
    DynamicMessage box = new VersionTolerantCodec<>(ours(), registry).decode(old(), schema(OLD).info());
    assertEquals("crate", box.text("name").orElseThrow());
    assertEquals(2.5, box.number("weight").orElseThrow());
    assertEquals("bottom", box.text("parts[1].label").orElseThrow());
    assertEquals(0, box.number("parts[1].kind").orElseThrow());
    assertEquals(0, box.number("code[2]").orElseThrow());
    assertEquals(0, box.number("checked").orElseThrow());
  }

  @Test
  void anyVersionIsAskedFor() throws Exception {
    MessageInfo info = new VersionTolerantCodec<>(ours(), registry).info();
    assertEquals("lab_msgs/Box", info.type());
    assertTrue(info.accepts(schema(OLD).info().md5()));
  }

  @Test
  void aFieldThatIsSomethingElseIsNamed() throws Exception {
    MessageInfo other = schema("float32 weight\n").info();
    ByteBuffer bytes = ByteBuffer.wrap(new byte[4]);
    MessageException e = assertThrows(MessageException.class,
        () -> new VersionTolerantCodec<>(ours(), registry).decode(bytes, other));
    assertTrue(e.getMessage().contains("weight"), e.getMessage());
  }

  @Test
  void anotherTypeAndOneWithNothingInCommonAreRefused() throws Exception {
    VersionTolerantCodec<DynamicMessage> codec = new VersionTolerantCodec<>(ours(), registry);
    MessageInfo stranger = schema("int8 x\n").info();
    assertThrows(MessageException.class, () -> codec.decode(ByteBuffer.wrap(new byte[1]), stranger));
    MessageInfo elsewhere = MessageSchema.parse("lab_msgs/Cup", OLD).info();
    assertThrows(MessageException.class, () -> codec.decode(old(), elsewhere));
  }

  @Test
  void damagedBytesOfAnOlderVersionAreRefusedWhereverTheyEnd() throws Exception {
    VersionTolerantCodec<DynamicMessage> codec = new VersionTolerantCodec<>(ours(), registry);
    MessageInfo info = schema(OLD).info();
    for (int length = 0; length < old().limit(); length++) {
      ByteBuffer cut = old().slice(0, length);
      assertThrows(MessageException.class, () -> codec.decode(cut, info));
    }
  }
}
