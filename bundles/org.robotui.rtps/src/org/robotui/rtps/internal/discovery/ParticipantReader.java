package org.robotui.rtps.internal.discovery;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.OptionalInt;
import org.robotui.rtps.Guid;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.ProtocolVersion;
import org.robotui.rtps.VendorId;
import org.robotui.rtps.internal.wire.ParameterId;
import org.robotui.rtps.internal.wire.ParameterValue;
import org.robotui.rtps.internal.wire.WireException;

/** Collects what a participant says of itself. What is not said has the value that the specification gives. */
final class ParticipantReader {

  private static final Duration STANDARD_LEASE = Duration.ofSeconds(100);

  private Guid guid = Guid.UNKNOWN;

  private VendorId vendor = VendorId.UNKNOWN;

  private ProtocolVersion version = ProtocolVersion.V2_3;

  private String name = "";

  private String tag = "";

  private OptionalInt domain = OptionalInt.empty();

  private Duration lease = STANDARD_LEASE;

  private int endpoints;

  private final LocatorList metatraffic = new LocatorList();

  private final LocatorList userTraffic = new LocatorList();

  private ByteBuffer userData = ByteBuffer.allocate(0);

  void take(int id, ByteBuffer value) throws WireException {
    switch (id) {
      case ParameterId.PARTICIPANT_GUID -> guid = ParameterValue.guid(value);
      case ParameterId.VENDOR_ID -> vendor = new VendorId(ParameterValue.pair(value));
      case ParameterId.PROTOCOL_VERSION -> {
        int both = ParameterValue.pair(value);
        version = new ProtocolVersion(both >> 8, both & 0xff);
      }
      case ParameterId.ENTITY_NAME -> name = ParameterValue.text(value, FieldBounds.NAME);
      case ParameterId.DOMAIN_TAG -> tag = ParameterValue.text(value, FieldBounds.NAME);
      case ParameterId.DOMAIN_ID -> domain = OptionalInt.of(ParameterValue.number(value));
      case ParameterId.LEASE -> lease = ParameterValue.duration(value);
      case ParameterId.BUILTIN_ENDPOINTS,
          ParameterId.BUILTIN_ENDPOINTS_OLD -> endpoints |= ParameterValue.number(value);
      case ParameterId.METATRAFFIC_UNICAST_LOCATOR -> metatraffic.unicast(value);
      case ParameterId.METATRAFFIC_MULTICAST_LOCATOR -> metatraffic.multicast(value);
      case ParameterId.DEFAULT_UNICAST_LOCATOR -> userTraffic.unicast(value);
      case ParameterId.DEFAULT_MULTICAST_LOCATOR -> userTraffic.multicast(value);
      case ParameterId.USER_DATA -> userData = ParameterValue.octets(value, FieldBounds.USER_DATA);
      default -> {
        // properties, security and what vendors add are not used
      }
    }
  }

  ParticipantInfo build() throws WireException {
    if (!guid.equals(guid.participant()) || guid.equals(Guid.participant(Guid.UNKNOWN.prefix()))) {
      throw new WireException("no participant has the GUID " + guid);
    }
    if (!tag.isEmpty()) {
      throw new WireException("participant of the domain tag '" + tag + "'");
    }
    return new ParticipantInfo(guid, vendor, version, name, domain, lease, endpoints, metatraffic.build(),
        userTraffic.build(), userData);
  }
}
