package org.robotui.ros.internal.xmlrpc;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.Map;
import org.robotui.ros.XmlRpcValue;

/** Writes XML-RPC documents. */
public final class XmlRpcWriter {

  private final StringBuilder out = new StringBuilder("<?xml version=\"1.0\"?>\n");

  private XmlRpcWriter() {}

  /** Writes a request. */
  public static byte[] call(MethodCall call) {
    XmlRpcWriter writer = new XmlRpcWriter();
    writer.out.append("<methodCall><methodName>");
    writer.escape(call.method());
    writer.out.append("</methodName><params>");
    call.arguments().forEach(writer::param);
    writer.out.append("</params></methodCall>\n");
    return writer.bytes();
  }

  /** Writes a response with its one value. */
  public static byte[] response(XmlRpcValue value) {
    XmlRpcWriter writer = new XmlRpcWriter();
    writer.out.append("<methodResponse><params>");
    writer.param(value);
    writer.out.append("</params></methodResponse>\n");
    return writer.bytes();
  }

  /** Writes a fault. */
  public static byte[] fault(XmlRpcFault fault) {
    XmlRpcWriter writer = new XmlRpcWriter();
    writer.out.append("<methodResponse><fault>");
    writer.value(new XmlRpcValue.Struct(Map.of("faultCode", XmlRpcValue.of(fault.code()),
        "faultString", XmlRpcValue.of(fault.getMessage()))));
    writer.out.append("</fault></methodResponse>\n");
    return writer.bytes();
  }

  private byte[] bytes() {
    return out.toString().getBytes(StandardCharsets.UTF_8);
  }

  private void param(XmlRpcValue value) {
    out.append("<param>");
    value(value);
    out.append("</param>");
  }

  private void value(XmlRpcValue value) {
    out.append("<value>");
    switch (value) {
      case XmlRpcValue.Text text -> element("string", text.value());
      case XmlRpcValue.Int number -> element("int", Integer.toString(number.value()));
      case XmlRpcValue.Bool bool -> element("boolean", bool.value() ? "1" : "0");
      case XmlRpcValue.Real real -> element("double", real(real.value()));
      case XmlRpcValue.DateTime date -> element("dateTime.iso8601", date.iso8601());
      case XmlRpcValue.Binary binary -> element("base64", Base64.getEncoder().encodeToString(binary.bytes()));
      case XmlRpcValue.Array array -> array(array);
      case XmlRpcValue.Struct struct -> struct(struct);
    }
    out.append("</value>");
  }

  /** The spellings that C's strtod and Python's float both read. */
  private static String real(double value) {
    return Double.isNaN(value) ? "nan"
        : Double.isInfinite(value) ? (value > 0 ? "inf" : "-inf")
            : Double.toString(value);
  }

  private void array(XmlRpcValue.Array array) {
    out.append("<array><data>");
    array.items().forEach(this::value);
    out.append("</data></array>");
  }

  private void struct(XmlRpcValue.Struct struct) {
    out.append("<struct>");
    struct.members().forEach((name, member) -> {
      out.append("<member>");
      element("name", name);
      value(member);
      out.append("</member>");
    });
    out.append("</struct>");
  }

  private void element(String name, String text) {
    out.append('<').append(name).append('>');
    escape(text);
    out.append("</").append(name).append('>');
  }

  private void escape(String text) {
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      switch (c) {
        case '<' -> out.append("&lt;");
        case '>' -> out.append("&gt;");
        case '&' -> out.append("&amp;");
        case '\r' -> out.append("&#13;");
        default -> out.append(c);
      }
    }
  }
}
