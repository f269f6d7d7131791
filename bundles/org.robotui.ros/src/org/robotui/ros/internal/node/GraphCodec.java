package org.robotui.ros.internal.node;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.ros.SystemState;
import org.robotui.ros.TopicInfo;
import org.robotui.ros.XmlRpcValue;

/** Reads the nested lists in which the master describes the graph; anything malformed is left out. */
final class GraphCodec {

  private GraphCodec() {}

  static List<XmlRpcValue> list(XmlRpcValue value) {
    return value instanceof XmlRpcValue.Array array ? array.items() : List.of();
  }

  static List<String> texts(XmlRpcValue value) {
    List<String> texts = new ArrayList<>();
    for (XmlRpcValue item : list(value)) {
      if (item instanceof XmlRpcValue.Text text) {
        texts.add(text.value());
      }
    }
    return texts;
  }

  static List<TopicInfo> topics(XmlRpcValue value) {
    return list(value).stream().map(GraphCodec::texts).filter(pair -> pair.size() == 2)
        .map(pair -> new TopicInfo(pair.get(0), pair.get(1))).toList();
  }

  static SystemState state(XmlRpcValue value) {
    List<XmlRpcValue> parts = list(value);
    return parts.size() < 3 ? new SystemState(Map.of(), Map.of(), Map.of())
        : new SystemState(nodes(parts.get(0)), nodes(parts.get(1)), nodes(parts.get(2)));
  }

  private static Map<String, List<String>> nodes(XmlRpcValue value) {
    Map<String, List<String>> nodes = new LinkedHashMap<>();
    for (XmlRpcValue entry : list(value)) {
      List<XmlRpcValue> pair = list(entry);
      if (pair.size() == 2 && pair.get(0) instanceof XmlRpcValue.Text name) {
        nodes.put(name.value(), List.copyOf(texts(pair.get(1))));
      }
    }
    return nodes;
  }
}
