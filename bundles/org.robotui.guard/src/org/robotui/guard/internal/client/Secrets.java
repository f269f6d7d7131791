package org.robotui.guard.internal.client;

import java.security.SecureRandom;
import org.robotui.guard.internal.wire.Wire;

/** What only we and our guard know: what we say, and what it says. */
record Secrets(byte[] knock, byte[] answer) {
  static Secrets fresh() {
    SecureRandom random = new SecureRandom();
    byte[] knock = new byte[Wire.SECRET];
    byte[] answer = new byte[Wire.SECRET];
    random.nextBytes(knock);
    random.nextBytes(answer);
    return new Secrets(knock, answer);
  }
}
