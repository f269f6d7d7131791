package org.robotui.rtps.internal.discovery;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.internal.wire.Encapsulation;
import org.robotui.rtps.internal.wire.ParameterId;
import org.robotui.rtps.internal.wire.ParameterOutput;
import org.robotui.rtps.internal.wire.WireException;

/** What participants say of themselves, as the samples that announce them. */
public final class ParticipantCodec {

  private ParticipantCodec() {}

  /**
   * Reads what a participant says of itself.
   *
   * @param payload of a sample, from its encapsulation header on; its position moves
   * @throws WireException if it is no such sample, or is one of another domain tag
   */
  public static ParticipantInfo read(ByteBuffer payload) throws WireException {
    ParticipantReader reader = new ParticipantReader();
    PayloadLists.open(payload, reader::take);
    return reader.build();
  }

  /**
   * Writes what a participant says of itself.
   *
   * @param order the byte order
   * @return the payload of a sample
   */
  public static ByteBuffer write(ParticipantInfo info, ByteOrder order) {
    ParameterOutput out = new ParameterOutput(order);
    out.pair(ParameterId.PROTOCOL_VERSION, info.version().major() << 8 | info.version().minor());
    out.pair(ParameterId.VENDOR_ID, info.vendor().value());
    out.guid(ParameterId.PARTICIPANT_GUID, info.guid());
    info.domain().ifPresent(domain -> out.number(ParameterId.DOMAIN_ID, domain));
    out.locators(ParameterId.METATRAFFIC_UNICAST_LOCATOR, info.metatraffic().unicast());
    out.locators(ParameterId.METATRAFFIC_MULTICAST_LOCATOR, info.metatraffic().multicast());
    out.locators(ParameterId.DEFAULT_UNICAST_LOCATOR, info.userTraffic().unicast());
    out.locators(ParameterId.DEFAULT_MULTICAST_LOCATOR, info.userTraffic().multicast());
    out.duration(ParameterId.LEASE, info.lease());
    out.number(ParameterId.BUILTIN_ENDPOINTS, info.builtInEndpoints());
    if (!info.name().isEmpty()) {
      out.text(ParameterId.ENTITY_NAME, info.name());
    }
    if (info.userData().hasRemaining()) {
      out.octets(ParameterId.USER_DATA, info.userData());
    }
    return Encapsulation.PL_CDR.payload(out.finish());
  }
}
