package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class TerminalOutTest {
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private final TerminalOut out = new TerminalOut(bytes, StandardCharsets.UTF_8);

  @Test
  void whatWouldSteerTheTerminalIsShown() {
    out.println("Nat\u001b[31malie\u0007\u009b2J\u202e");
    out.print("a\r\nb\n");
    out.printf("%s|", "\u0000");

    assertEquals("Nat\\u001b[31malie\\u0007\\u009b2J\\u202e\na\\u000d\nb\n\\u0000|", printed());
  }

  @Test
  void wordsOfAllLanguagesAreLeftAlone() {
    out.println("Räder \u8f6e\u5b50 \ud83e\udd16 \u0639\u062c\u0644\u0629");

    assertEquals("Räder \u8f6e\u5b50 \ud83e\udd16 \u0639\u062c\u0644\u0629\n", printed());
  }

  private String printed() {
    out.flush();
    return bytes.toString(StandardCharsets.UTF_8);
  }
}
