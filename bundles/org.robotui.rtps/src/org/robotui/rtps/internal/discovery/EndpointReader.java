package org.robotui.rtps.internal.discovery;

import java.nio.ByteBuffer;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Guid;
import org.robotui.rtps.internal.wire.ParameterId;
import org.robotui.rtps.internal.wire.ParameterValue;
import org.robotui.rtps.internal.wire.WireException;

/** Collects what is said of an endpoint. */
final class EndpointReader {

  private final EndpointKind kind;

  private final QosReader qos;

  private final LocatorList locators = new LocatorList();

  private Guid guid = Guid.UNKNOWN;

  private String topic = "";

  private String type = "";

  private ByteBuffer userData = ByteBuffer.allocate(0);

  private boolean wantsInlineQos;

  EndpointReader(EndpointKind kind) {
    this.kind = kind;
    this.qos = new QosReader(kind);
  }

  void take(int id, ByteBuffer value) throws WireException {
    switch (id) {
      case ParameterId.ENDPOINT_GUID -> guid = ParameterValue.guid(value);
      case ParameterId.KEY_HASH -> guid = guid.equals(Guid.UNKNOWN) ? ParameterValue.guid(value) : guid;
      case ParameterId.TOPIC_NAME -> topic = ParameterValue.text(value, FieldBounds.NAME);
      case ParameterId.TYPE_NAME -> type = ParameterValue.text(value, FieldBounds.NAME);
      case ParameterId.UNICAST_LOCATOR -> locators.unicast(value);
      case ParameterId.MULTICAST_LOCATOR -> locators.multicast(value);
      case ParameterId.USER_DATA -> userData = ParameterValue.octets(value, FieldBounds.USER_DATA);
      case ParameterId.EXPECTS_INLINE_QOS -> wantsInlineQos = ParameterValue.flag(value);
      default -> qos.take(id, value);
    }
  }

  EndpointInfo build() throws WireException {
    boolean right = kind == EndpointKind.WRITER ? guid.entity().writer() : guid.entity().reader();
    if (!right || guid.prefix().equals(Guid.UNKNOWN.prefix())) {
      throw new WireException("no " + kind + " has the GUID " + guid);
    }
    if (topic.isEmpty() || type.isEmpty()) {
      throw new WireException("an endpoint without a topic or a type");
    }
    return new EndpointInfo(guid, kind, topic, type, qos.build(), userData, locators.build(), wantsInlineQos);
  }
}
