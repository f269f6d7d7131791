package org.robotui.rfic.ros.internal.call;

import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.api.port.CallException;
import org.robotui.ros.XmlRpcValue;

/** Parameter values as plain Java values and back. */
final class ParameterValues {
  private ParameterValues() {}

  static Object plain(XmlRpcValue value) {
    return switch (value) {
      case XmlRpcValue.Text t -> t.value();
      case XmlRpcValue.Int i -> (long) i.value();
      case XmlRpcValue.Bool b -> b.value();
      case XmlRpcValue.Real r -> r.value();
      case XmlRpcValue.DateTime d -> d.iso8601();
      case XmlRpcValue.Binary b -> Base64.getEncoder().encodeToString(b.bytes());
      case XmlRpcValue.Array a -> a.items().stream().map(ParameterValues::plain).toList();
      case XmlRpcValue.Struct s -> {
        Map<String, Object> members = new LinkedHashMap<>();
        s.members().forEach((k, v) -> members.put(k, plain(v)));
        yield members;
      }
    };
  }

  static XmlRpcValue ros(Object value) throws CallException {
    return switch (value) {
      case String s -> XmlRpcValue.of(s);
      case Boolean b -> XmlRpcValue.of(b);
      case Double d -> XmlRpcValue.of(d);
      case Number n when n.longValue() == n.intValue() -> XmlRpcValue.of(n.intValue());
      case List<?> list -> array(list);
      case Map<?, ?> map -> struct(map);
      default -> throw new CallException("a ROS parameter cannot hold " + value + " (integers have 32 bits)");
    };
  }

  private static XmlRpcValue array(List<?> list) throws CallException {
    XmlRpcValue[] items = new XmlRpcValue[list.size()];
    for (int i = 0; i < items.length; i++) {
      items[i] = ros(list.get(i));
    }
    return XmlRpcValue.of(items);
  }

  private static XmlRpcValue struct(Map<?, ?> map) throws CallException {
    Map<String, XmlRpcValue> members = new LinkedHashMap<>();
    for (Map.Entry<?, ?> e : map.entrySet()) {
      members.put(e.getKey().toString(), ros(e.getValue()));
    }
    return new XmlRpcValue.Struct(members);
  }
}
