package org.robotui.ros2.internal.link;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.jupiter.api.Test;
import org.robotui.message.CdrReader;
import org.robotui.message.CdrWriter;
import org.robotui.message.MessageException;

class CallHeaderTest {

  @Test
  void theHeaderStandsBeforeTheFirstFieldInTheByteOrderOfTheMessage() throws MessageException {
    for (ByteOrder order : new ByteOrder[]{ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN}) {
      ByteBuffer payload = new CdrWriter(order).u8(1).f64(0.5).view();
      ByteBuffer whole = new CallHeader(-7, 42).before(payload);
      CdrReader reader = new CdrReader(whole);
      assertEquals(-7, reader.int64("client"));
      assertEquals(42, reader.int64("sequence"));
      assertEquals(1, reader.uint8("flag"));
      assertEquals(0.5, reader.float64("number"), "what follows keeps its place");
      CallHeader.Opened opened = CallHeader.open(whole).orElseThrow();
      assertEquals(new CallHeader(-7, 42), opened.header());
      assertEquals(payload, opened.payload());
    }
  }

  @Test
  void aMessageThatIsTooShortHasNoHeader() {
    for (int length = 0; length < 20; length++) {
      assertTrue(CallHeader.open(ByteBuffer.allocate(length)).isEmpty(), "of " + length + " bytes");
    }
  }
}
