package org.robotui.ros.internal.xmlrpc;

import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.ros.XmlRpcValue;

/** Parses XML-RPC documents, strictly: unknown elements, attributes and excessive nesting are errors. */
public final class XmlRpcReader {

  private static final int MAX_DEPTH = 64;
  private static final int MAX_DATE = 64;

  private final XmlScanner xml;

  private XmlRpcReader(byte[] document) throws XmlRpcException {
    xml = new XmlScanner(document);
  }

  /** Parses a request. */
  public static MethodCall call(byte[] document) throws XmlRpcException {
    return new XmlRpcReader(document).methodCall();
  }

  /** Parses a response; a fault becomes an exception. */
  public static XmlRpcValue response(byte[] document) throws XmlRpcException, XmlRpcFault {
    return new XmlRpcReader(document).methodResponse();
  }

  private MethodCall methodCall() throws XmlRpcException {
    xml.prolog();
    require(xml.open("methodCall"), "a method call without content");
    String name = leaf("methodName").strip();
    List<XmlRpcValue> arguments = xml.opens("params") ? params() : List.of();
    xml.close("methodCall");
    xml.end();
    return new MethodCall(name, arguments);
  }

  private XmlRpcValue methodResponse() throws XmlRpcException, XmlRpcFault {
    xml.prolog();
    require(xml.open("methodResponse"), "a method response without content");
    if (xml.opens("fault")) {
      throw fault();
    }
    List<XmlRpcValue> results = params();
    xml.close("methodResponse");
    xml.end();
    require(results.size() == 1, "a response has one value, this one has " + results.size());
    return results.get(0);
  }

  private XmlRpcFault fault() throws XmlRpcException {
    require(xml.open("fault"), "a fault without content");
    XmlRpcValue value = value(0);
    xml.close("fault");
    xml.close("methodResponse");
    xml.end();
    if (value instanceof XmlRpcValue.Struct struct
        && struct.members().get("faultCode") instanceof XmlRpcValue.Int code
        && struct.members().get("faultString") instanceof XmlRpcValue.Text text) {
      return new XmlRpcFault(code.value(), text.value());
    }
    throw xml.error("a fault without faultCode and faultString");
  }

  private List<XmlRpcValue> params() throws XmlRpcException {
    List<XmlRpcValue> values = new ArrayList<>();
    if (!xml.open("params")) {
      return values;
    }
    while (xml.opens("param")) {
      require(xml.open("param"), "an empty <param/>");
      values.add(value(0));
      xml.close("param");
    }
    xml.close("params");
    return values;
  }

  private XmlRpcValue value(int depth) throws XmlRpcException {
    require(depth < MAX_DEPTH, "values nested deeper than " + MAX_DEPTH);
    if (!xml.open("value")) {
      return XmlRpcValue.of("");
    }
    String text = xml.text();
    String type = text.isBlank() ? xml.peekElement() : "";
    XmlRpcValue value = type.isEmpty() ? XmlRpcValue.of(text) : typed(type, depth);
    xml.close("value");
    return value;
  }

  private XmlRpcValue typed(String type, int depth) throws XmlRpcException {
    return switch (type) {
      case "string" -> XmlRpcValue.of(leaf(type));
      case "int", "i4" -> XmlRpcValue.of(integer(leaf(type).strip()));
      case "boolean" -> bool(leaf(type).strip());
      case "double" -> XmlRpcValue.of(real(leaf(type).strip()));
      case "dateTime.iso8601" -> date(leaf(type).strip());
      case "base64" -> base64(leaf(type));
      case "array" -> array(depth);
      case "struct" -> struct(depth);
      default -> throw xml.error("unknown type <" + shorten(type) + ">");
    };
  }

  private String leaf(String name) throws XmlRpcException {
    if (!xml.open(name)) {
      return "";
    }
    String text = xml.text();
    xml.close(name);
    return text;
  }

  private XmlRpcValue array(int depth) throws XmlRpcException {
    List<XmlRpcValue> items = new ArrayList<>();
    require(xml.open("array"), "an array without <data>");
    if (xml.open("data")) {
      while (xml.opens("value")) {
        items.add(value(depth + 1));
      }
      xml.close("data");
    }
    xml.close("array");
    return new XmlRpcValue.Array(items);
  }

  private XmlRpcValue struct(int depth) throws XmlRpcException {
    Map<String, XmlRpcValue> members = new LinkedHashMap<>();
    if (xml.open("struct")) {
      while (xml.opens("member")) {
        require(xml.open("member"), "an empty <member/>");
        members.put(leaf("name"), value(depth + 1));
        xml.close("member");
      }
      xml.close("struct");
    }
    return new XmlRpcValue.Struct(members);
  }

  private int integer(String text) throws XmlRpcException {
    try {
      return Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw xml.error("'" + shorten(text) + "' is no 32-bit integer");
    }
  }

  private XmlRpcValue bool(String text) throws XmlRpcException {
    require(text.equals("0") || text.equals("1"), "'" + shorten(text) + "' is no boolean");
    return XmlRpcValue.of(text.equals("1"));
  }

  private double real(String text) throws XmlRpcException {
    try {
      return switch (text.toLowerCase(java.util.Locale.ROOT)) {
        case "nan", "-nan" -> Double.NaN;
        case "inf", "+inf", "infinity" -> Double.POSITIVE_INFINITY;
        case "-inf", "-infinity" -> Double.NEGATIVE_INFINITY;
        default -> Double.parseDouble(text);
      };
    } catch (NumberFormatException e) {
      throw xml.error("'" + shorten(text) + "' is no double");
    }
  }

  private XmlRpcValue date(String text) throws XmlRpcException {
    require(text.length() <= MAX_DATE, "a date of " + text.length() + " characters");
    return new XmlRpcValue.DateTime(text);
  }

  private XmlRpcValue base64(String text) throws XmlRpcException {
    try {
      return new XmlRpcValue.Binary(Base64.getDecoder().decode(text.replaceAll("\\s", "")));
    } catch (IllegalArgumentException e) {
      throw xml.error("bad base64: " + e.getMessage());
    }
  }

  private void require(boolean condition, String problem) throws XmlRpcException {
    if (!condition) {
      throw xml.error(problem);
    }
  }

  private static String shorten(String text) {
    return text.length() <= 40 ? text : text.substring(0, 40) + "...";
  }
}
