package org.robotui.rtps.internal.discovery;

import java.nio.ByteBuffer;
import org.robotui.rtps.internal.wire.Encapsulation;
import org.robotui.rtps.internal.wire.ParameterInput;
import org.robotui.rtps.internal.wire.WireException;

/** Payloads that are parameter lists. */
final class PayloadLists {

  /** Takes one parameter after another. */
  @FunctionalInterface
  interface Taker {
    void take(int id, ByteBuffer value) throws WireException;
  }

  private PayloadLists() {}

  static void open(ByteBuffer payload, Taker taker) throws WireException {
    Encapsulation encoding = Encapsulation.read(payload);
    if (encoding != Encapsulation.PL_CDR) {
      throw new WireException("discovery in the encoding " + encoding);
    }
    ParameterInput parameters = new ParameterInput(payload);
    while (parameters.next()) {
      try {
        taker.take(parameters.id(), parameters.value());
      } catch (WireException e) {
        throw new WireException("parameter 0x%04x: %s".formatted(parameters.id(), e.getMessage()));
      }
    }
  }
}
