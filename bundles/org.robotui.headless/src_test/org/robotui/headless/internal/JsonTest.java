package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class JsonTest {
  @Test
  void writesOneObjectInOneLine() {
    String text = new Json().put("a", "b").put("n", 3L).put("x", 0.5, 3).end();

    assertEquals("{\"a\":\"b\",\"n\":3,\"x\":0.500}", text);
  }

  @Test
  void numbersThatJsonCannotSayAreNull() {
    assertEquals("{\"age_s\":null,\"rate\":null}",
        new Json().put("age_s", Double.NaN, 3).put("rate", Double.POSITIVE_INFINITY, 1).end());
  }

  @Test
  void escapesWhatWouldBreakTheLine() {
    assertEquals("\"say \\\"hi\\\" \\\\ \\n\\r\\t\\u0000\\u001b\\u007f\"",
        Json.quote("say \"hi\" \\ \n\r\t\0\u001b\u007f"));
  }

  @Test
  void keepsOtherCharactersAndEscapesHalfOnes() {
    assertEquals("\"−1.2 µm \uD83E\uDD16\"", Json.quote("−1.2 µm \uD83E\uDD16"));
    assertEquals("\"\\ud83e!\\udd16\"", Json.quote("\uD83E!\uDD16"));
  }

  @Test
  void anEmptyObjectIsStillOne() {
    assertEquals("{}", new Json().end());
  }
}
