package org.robotui.rtps.internal.discovery;

import java.nio.ByteBuffer;
import org.robotui.rtps.Guid;
import org.robotui.rtps.internal.wire.ParameterId;
import org.robotui.rtps.internal.wire.ParameterValue;
import org.robotui.rtps.internal.wire.WireException;

/** Finds the GUID of whom a key is: that of an endpoint, which may stand beside that of its participant. */
final class KeyReader {

  private Guid participant = Guid.UNKNOWN;

  private Guid endpoint = Guid.UNKNOWN;

  void take(int id, ByteBuffer value) throws WireException {
    switch (id) {
      case ParameterId.PARTICIPANT_GUID -> participant = ParameterValue.guid(value);
      case ParameterId.ENDPOINT_GUID, ParameterId.KEY_HASH -> endpoint = ParameterValue.guid(value);
      default -> {
        // a key has nothing else
      }
    }
  }

  Guid build() throws WireException {
    Guid guid = endpoint.equals(Guid.UNKNOWN) ? participant : endpoint;
    if (guid.equals(Guid.UNKNOWN)) {
      throw new WireException("a key without a GUID");
    }
    return guid;
  }
}
