package org.robotui.rtps.internal.discovery;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Qos;
import org.robotui.rtps.internal.wire.Encapsulation;
import org.robotui.rtps.internal.wire.ParameterId;
import org.robotui.rtps.internal.wire.ParameterOutput;
import org.robotui.rtps.internal.wire.WireException;

/** What participants say of their writers and readers, as the samples that announce them. */
public final class EndpointCodec {

  private EndpointCodec() {}

  /**
   * Reads what is said of an endpoint.
   *
   * @param payload of a sample, from its encapsulation header on; its position moves
   * @param kind whether it came where writers or where readers are announced
   * @throws WireException if it is no such sample
   */
  public static EndpointInfo read(ByteBuffer payload, EndpointKind kind) throws WireException {
    EndpointReader reader = new EndpointReader(kind);
    PayloadLists.open(payload, reader::take);
    return reader.build();
  }

  /**
   * Reads of whom a sample tells that it is gone.
   *
   * @param payload the key of a sample, from its encapsulation header on; its position moves
   * @return the GUID of a participant or an endpoint
   * @throws WireException if it is no such key
   */
  public static Guid readKey(ByteBuffer payload) throws WireException {
    KeyReader reader = new KeyReader();
    PayloadLists.open(payload, reader::take);
    return reader.build();
  }

  /**
   * Writes of whom a sample tells that it is gone.
   *
   * @param gone a participant or an endpoint
   * @param order the byte order
   * @return the key of a sample
   */
  public static ByteBuffer writeKey(Guid gone, ByteOrder order) {
    boolean participant = gone.equals(gone.participant());
    ParameterOutput out = new ParameterOutput(order);
    out.guid(participant ? ParameterId.PARTICIPANT_GUID : ParameterId.ENDPOINT_GUID, gone);
    return Encapsulation.PL_CDR.payload(out.finish());
  }

  /**
   * Writes what is said of an endpoint.
   *
   * @param order the byte order
   * @return the payload of a sample
   */
  public static ByteBuffer write(EndpointInfo info, ByteOrder order) {
    ParameterOutput out = new ParameterOutput(order);
    out.guid(ParameterId.ENDPOINT_GUID, info.guid());
    out.guid(ParameterId.PARTICIPANT_GUID, info.participant());
    out.text(ParameterId.TOPIC_NAME, info.topic());
    out.text(ParameterId.TYPE_NAME, info.type());
    out.locators(ParameterId.UNICAST_LOCATOR, info.locators().unicast());
    out.locators(ParameterId.MULTICAST_LOCATOR, info.locators().multicast());
    if (info.kind() == EndpointKind.READER) {
      out.flag(ParameterId.EXPECTS_INLINE_QOS, info.wantsInlineQos());
    }
    qos(info.qos(), out);
    if (info.userData().hasRemaining()) {
      out.octets(ParameterId.USER_DATA, info.userData());
    }
    return Encapsulation.PL_CDR.payload(out.finish());
  }

  private static void qos(Qos qos, ParameterOutput out) {
    out.numberAndDuration(ParameterId.RELIABILITY, WireQos.reliability(qos.reliability()), WireQos.BLOCKING);
    out.number(ParameterId.DURABILITY, qos.durability().ordinal());
    out.numberAndDuration(ParameterId.LIVELINESS, qos.liveliness().ordinal(), qos.livelinessLease());
    out.number(ParameterId.OWNERSHIP, qos.ownership().ordinal());
    out.duration(ParameterId.DEADLINE, qos.deadline());
    out.duration(ParameterId.LIFESPAN, qos.lifespan());
    out.numbers(ParameterId.HISTORY, qos.history().ordinal(), qos.depth());
    List<Integer> encodings = qos.representations().stream().map(Enum::ordinal).toList();
    out.smallNumbers(ParameterId.DATA_REPRESENTATION, encodings);
    if (!qos.partitions().isEmpty()) {
      out.texts(ParameterId.PARTITION, qos.partitions());
    }
  }
}
