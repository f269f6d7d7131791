package org.robotui.core.internal.config;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.host.Problem;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.error.Mark;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;

/** Parses one YAML text into values with places. No tag constructs anything; depth and size are bounded. */
final class YamlFile {
  private static final int MAX_DEPTH = 40;
  private static final int MAX_CHARACTERS = 1 << 20;
  private static final int MAX_VALUES = 100_000;

  private final String file;
  private final Variables variables;
  private final List<Problem> problems;
  private int values;

  private YamlFile(String file, Variables variables, List<Problem> problems) {
    this.file = file;
    this.variables = variables;
    this.problems = problems;
  }

  /** Parses; what is wrong goes to the problems. An empty text is an empty section. */
  static Optional<YamlValue> parse(String file, String text, Variables variables, List<Problem> problems) {
    return new YamlFile(file, variables, problems).parse(text);
  }

  private Optional<YamlValue> parse(String text) {
    try {
      Optional<Node> root = Optional.ofNullable(new Yaml(limits()).compose(new StringReader(text)));
      return root.map(node -> value(node, 0)).or(() -> Optional.of(new YamlValue.Section(List.of(), new Place(file, 1, 1))));
    } catch (MarkedYAMLException e) {
      Place at = Optional.ofNullable(e.getProblemMark()).map(this::place).orElse(new Place(file, 1, 1));
      problems.add(at.error("this is no YAML: " + e.getProblem()));
    } catch (YAMLException e) {
      problems.add(new Place(file, 1, 1).error("this is no YAML: " + e.getMessage()));
    }
    return Optional.empty();
  }

  private static LoaderOptions limits() {
    LoaderOptions options = new LoaderOptions();
    options.setNestingDepthLimit(MAX_DEPTH);
    options.setCodePointLimit(MAX_CHARACTERS);
    options.setAllowRecursiveKeys(false);
    return options;
  }

  private YamlValue value(Node node, int depth) {
    Place place = place(node.getStartMark());
    if (depth > MAX_DEPTH || ++values > MAX_VALUES) {
      throw new YAMLException("aliases make this endless or too large");
    }
    return switch (node) {
      case ScalarNode s -> new YamlValue.Scalar(variables.replaceIn(s.getValue(), place, problems), s.isPlain(), place);
      case SequenceNode s -> new YamlValue.Items(s.getValue().stream().map(n -> value(n, depth + 1)).toList(), place);
      case MappingNode m -> section(m, place, depth);
      default -> throw new YAMLException("unexpected " + node.getNodeId());
    };
  }

  private YamlValue section(MappingNode node, Place place, int depth) {
    Map<String, YamlValue.Entry> entries = new LinkedHashMap<>();
    for (NodeTuple tuple : node.getValue()) {
      Place at = place(tuple.getKeyNode().getStartMark());
      String key = tuple.getKeyNode() instanceof ScalarNode s ? s.getValue() : "";
      YamlValue.Entry entry = new YamlValue.Entry(key, at, value(tuple.getValueNode(), depth + 1));
      if (key.isEmpty()) {
        problems.add(at.error("a key must be a word"));
      } else if (entries.putIfAbsent(key, entry) instanceof YamlValue.Entry first) {
        problems.add(at.error("'" + key + "' stands here twice; the first is in line " + first.place().line()));
      }
    }
    return new YamlValue.Section(new ArrayList<>(entries.values()), place);
  }

  private Place place(Mark mark) {
    return new Place(file, mark.getLine() + 1, mark.getColumn() + 1);
  }
}
