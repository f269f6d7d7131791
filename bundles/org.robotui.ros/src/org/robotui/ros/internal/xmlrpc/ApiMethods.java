package org.robotui.ros.internal.xmlrpc;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.ros.XmlRpcValue;

/**
 * The methods of a ROS API: each takes arguments of fixed types, first of all the caller's id, and answers
 * {@code [code, status, value]}.
 */
public final class ApiMethods implements XmlRpcHandler {

  /** Codes of answers. */
  private static final int SUCCESS = 1;
  private static final int ERROR = -1;

  /** What a method does; the arguments have the declared types. */
  @FunctionalInterface
  public interface Body {

    XmlRpcValue answer(Arguments arguments) throws XmlRpcFault;
  }

  /** The arguments of one call, checked before. */
  public record Arguments(List<XmlRpcValue> values) {

    public String text(int index) {
      return ((XmlRpcValue.Text) values.get(index)).value();
    }

    public XmlRpcValue value(int index) {
      return values.get(index);
    }

    public List<XmlRpcValue> list(int index) {
      return ((XmlRpcValue.Array) values.get(index)).items();
    }

    /** The node that calls. */
    public String caller() {
      return text(0);
    }
  }

  private record Method(List<Class<? extends XmlRpcValue>> types, Body body) {

    String describe() {
      return "(" + String.join(", ", types.stream().map(Class::getSimpleName).toList()) + ")";
    }
  }

  private final Map<String, List<Method>> methods = new HashMap<>();

  /** Adds a method, or one more form of it, whose first argument is the caller's id. */
  @SafeVarargs
  public final ApiMethods add(String name, Body body, Class<? extends XmlRpcValue>... types) {
    List<Class<? extends XmlRpcValue>> all = new ArrayList<>();
    all.add(XmlRpcValue.Text.class);
    Collections.addAll(all, types);
    methods.computeIfAbsent(name, key -> new ArrayList<>()).add(new Method(all, body));
    return this;
  }

  public static XmlRpcValue success(String status, XmlRpcValue value) {
    return XmlRpcValue.of(XmlRpcValue.of(SUCCESS), XmlRpcValue.of(status), value);
  }

  public static XmlRpcValue success(String status, int value) {
    return success(status, XmlRpcValue.of(value));
  }

  public static XmlRpcValue error(String status, XmlRpcValue value) {
    return XmlRpcValue.of(XmlRpcValue.of(ERROR), XmlRpcValue.of(status), value);
  }

  @Override
  public XmlRpcValue handle(MethodCall call) throws XmlRpcFault {
    if (call.method().equals("system.multicall")) {
      return multicall(call);
    }
    List<Method> forms = methods.getOrDefault(call.method(), List.of());
    for (Method form : forms) {
      if (fits(form.types(), call.arguments())) {
        return form.body().answer(new Arguments(call.arguments()));
      }
    }
    if (forms.isEmpty()) {
      throw new XmlRpcFault(-32601, "there is no method '" + call.method() + "'");
    }
    return error(call.method() + " takes " + String.join(" or ", forms.stream().map(Method::describe).toList()),
        XmlRpcValue.of(0));
  }

  private static boolean fits(List<Class<? extends XmlRpcValue>> types, List<XmlRpcValue> arguments) {
    if (types.size() != arguments.size()) {
      return false;
    }
    for (int i = 0; i < types.size(); i++) {
      if (!types.get(i).isInstance(arguments.get(i))) {
        return false;
      }
    }
    return true;
  }

  private XmlRpcValue multicall(MethodCall outer) throws XmlRpcFault {
    List<XmlRpcValue> answers = new ArrayList<>();
    if (outer.arguments().size() == 1 && outer.arguments().get(0) instanceof XmlRpcValue.Array calls) {
      for (XmlRpcValue call : calls.items()) {
        answers.add(one(call));
      }
      return new XmlRpcValue.Array(answers);
    }
    throw new XmlRpcFault(-32602, "system.multicall takes one list of calls");
  }

  private XmlRpcValue one(XmlRpcValue call) {
    try {
      if (call instanceof XmlRpcValue.Struct struct
          && struct.members().get("methodName") instanceof XmlRpcValue.Text name
          && struct.members().get("params") instanceof XmlRpcValue.Array params
          && !name.value().startsWith("system.")) {
        return XmlRpcValue.of(handle(new MethodCall(name.value(), params.items())));
      }
      throw new XmlRpcFault(-32602, "a call of system.multicall is {methodName, params}");
    } catch (XmlRpcFault e) {
      return new XmlRpcValue.Struct(Map.of("faultCode", XmlRpcValue.of(e.code()),
          "faultString", XmlRpcValue.of(e.getMessage())));
    }
  }
}
