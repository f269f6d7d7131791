package org.robotui.rtps.internal.discovery;

import java.nio.ByteBuffer;
import java.time.Duration;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.History;
import org.robotui.rtps.Liveliness;
import org.robotui.rtps.Qos;
import org.robotui.rtps.internal.wire.ParameterId;
import org.robotui.rtps.internal.wire.ParameterValue;
import org.robotui.rtps.internal.wire.WireException;

/** Collects the QoS of an endpoint, beginning with what holds where nothing is said. */
final class QosReader {

  private Qos qos;

  QosReader(EndpointKind kind) {
    qos = WireQos.standard(kind);
  }

  void take(int id, ByteBuffer value) throws WireException {
    switch (id) {
      case ParameterId.RELIABILITY -> qos = qos.with(WireQos.reliability(ParameterValue.number(value)));
      case ParameterId.DURABILITY -> qos = qos.with(WireQos.durability(ParameterValue.number(value)));
      case ParameterId.LIVELINESS -> {
        Liveliness who = WireQos.liveliness(ParameterValue.number(value));
        Duration lease = ParameterValue.duration(value);
        qos = qos.with(who, lease);
      }
      case ParameterId.OWNERSHIP -> qos = qos.with(WireQos.ownership(ParameterValue.number(value)));
      case ParameterId.DEADLINE -> qos = qos.withTimes(ParameterValue.duration(value), qos.lifespan());
      case ParameterId.LIFESPAN -> qos = qos.withTimes(qos.deadline(), ParameterValue.duration(value));
      case ParameterId.HISTORY -> history(value);
      case ParameterId.PARTITION -> qos = qos.withPartitions(ParameterValue.texts(value, FieldBounds.PARTITIONS));
      case ParameterId.DATA_REPRESENTATION -> qos = qos.withRepresentations(
          WireQos.representations(ParameterValue.smallNumbers(value, FieldBounds.REPRESENTATIONS)));
      default -> {
        // types as they are described by XTypes, and what vendors add, are not used
      }
    }
  }

  /** It says nothing about matching, so that what makes no sense is not taken ill. */
  private void history(ByteBuffer value) throws WireException {
    boolean all = ParameterValue.number(value) == History.KEEP_ALL.ordinal();
    qos = qos.withDepth(Math.max(1, ParameterValue.number(value)));
    if (all) {
      qos = qos.keepAll();
    }
  }

  Qos build() {
    return qos;
  }
}
