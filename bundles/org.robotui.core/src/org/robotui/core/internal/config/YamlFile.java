package org.robotui.core.internal.config;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.robotui.api.config.Printable;
import org.robotui.api.config.TextRule;
import org.robotui.api.host.Problem;
import org.robotui.core.internal.config.ForNames.Formed;
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
import org.yaml.snakeyaml.reader.ReaderException;

/**
 * Parses one YAML text into values with places. A section or an element of a list that says {@code for:} is a template,
 * in whose place stands what is formed of it. No tag constructs anything; depth and size are bounded.
 */
final class YamlFile {
  private static final int MAX_DEPTH = 40;
  private static final int MAX_CHARACTERS = 1 << 20;
  private static final int MAX_VALUES = 100_000;
  /** The most characters that templates and variables may make of those in the file. */
  private static final int MAX_FORMED = 8 << 20;
  private static final int SHOWN = 60;

  private final String file;
  private final Variables variables;
  private final List<Problem> problems;
  private int values;
  private int characters;

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
      return root.map(node -> value(node, 0, Formed.NONE))
          .or(() -> Optional.of(new YamlValue.Section(List.of(), new Place(file, 1, 1))));
    } catch (MarkedYAMLException e) {
      Place at = Optional.ofNullable(e.getProblemMark()).map(this::place).orElse(new Place(file, 1, 1));
      problems.add(at.error("this is no YAML: " + Printable.of(String.valueOf(e.getProblem()))));
    } catch (ReaderException e) {
      problems.add(new Place(file, 1, 1).error("this is no text: it has the control character U+"
          + String.format("%04X", e.getCodePoint()) + ", as character " + (e.getPosition() + 1)));
    } catch (YAMLException e) {
      problems.add(new Place(file, 1, 1).error("this is no YAML: " + Printable.of(String.valueOf(e.getMessage()))));
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

  private YamlValue value(Node node, int depth, Formed formed) {
    Place place = place(node, formed);
    if (depth > MAX_DEPTH || ++values > MAX_VALUES) {
      throw new YAMLException("aliases or templates make this endless or too large");
    }
    return switch (node) {
      case ScalarNode s -> new YamlValue.Scalar(text(s, formed), s.isPlain(), place);
      case SequenceNode s -> items(s, place, depth, formed);
      case MappingNode m -> section(m, place, depth, formed);
      default -> throw new YAMLException("unexpected " + node.getNodeId());
    };
  }

  private String text(ScalarNode node, Formed formed) {
    Place place = place(node, formed);
    if (node.getValue().length() > TextRule.LONGEST) {
      problems.add(place.error(
          "a text of " + node.getValue().length() + " characters is too long; write at most " + TextRule.LONGEST));
      return Printable.beginning(node.getValue(), SHOWN);
    }
    String text = variables.replaceIn(node.getValue(), formed.words(), place, problems);
    if ((characters += text.length()) > MAX_FORMED) {
      throw new YAMLException("templates or variables make this too large");
    }
    if (!Printable.isPlain(text)) {
      problems.add(place.error("'" + Printable.beginning(text, SHOWN)
          + "' has line breaks or other control characters; write it in one line, without them"));
      return Printable.of(text);
    }
    return text;
  }

  private YamlValue items(SequenceNode node, Place place, int depth, Formed formed) {
    List<YamlValue> items = new ArrayList<>();
    for (Node item : node.getValue()) {
      form(item, formed, (body, who) -> items.add(value(body, depth + 1, who)));
    }
    return new YamlValue.Items(items, place);
  }

  private YamlValue section(MappingNode node, Place place, int depth, Formed formed) {
    Map<String, YamlValue.Entry> entries = new LinkedHashMap<>();
    for (NodeTuple tuple : node.getValue()) {
      form(tuple.getValueNode(), formed, (body, who) -> put(entries, tuple.getKeyNode(), body, depth, who));
    }
    return new YamlValue.Section(new ArrayList<>(entries.values()), place);
  }

  private void put(Map<String, YamlValue.Entry> entries, Node named, Node body, int depth, Formed formed) {
    Place at = place(named, formed);
    String key = named instanceof ScalarNode s ? text(s, formed) : "";
    YamlValue.Entry entry = new YamlValue.Entry(key, at, value(body, depth + 1, formed));
    if (key.isEmpty()) {
      problems.add(at.error("a key must be a word"));
    } else if (entries.putIfAbsent(key, entry) instanceof YamlValue.Entry first) {
      boolean template = first.place().line() == at.line() && !formed.robot().isEmpty();
      problems.add(at.error("'" + key + "' stands here twice; " + (template
          ? "write " + ForNames.ROBOT + " or ${number} in the name of the template"
          : "the first is in line " + first.place().line())));
    }
  }

  /** Gives what is formed of a node: the node itself, or what a template is without its names, for each of them. */
  private void form(Node node, Formed around, BiConsumer<Node, Formed> taker) {
    Optional<NodeTuple> names = node instanceof MappingNode m ? names(m, around) : Optional.empty();
    if (names.isEmpty()) {
      taker.accept(node, around);
      return;
    }
    MappingNode template = (MappingNode) node;
    List<NodeTuple> rest = template.getValue().stream().filter(t -> t != names.get()).toList();
    Node body = new MappingNode(template.getTag(), true, rest, template.getStartMark(), template.getEndMark(),
        template.getFlowStyle());
    ForNames who = new ForNames(problems);
    Node written = names.get().getValueNode();
    List<Node> each = written instanceof SequenceNode s ? s.getValue() : List.of(written);
    for (Node name : each) {
      who.add(name instanceof ScalarNode s ? text(s, around) : "", place(name, around));
    }
    who.formed().forEach(formed -> taker.accept(body, formed));
  }

  private Optional<NodeTuple> names(MappingNode node, Formed around) {
    return node.getValue().stream()
        .filter(t -> t.getKeyNode() instanceof ScalarNode s && ForNames.KEY.equals(s.getValue()))
        .filter(t -> t.getValueNode() instanceof SequenceNode
            || t.getValueNode() instanceof ScalarNode s && ForNames.isNames(text(s, around)))
        .findFirst();
  }

  private Place place(Node node, Formed formed) {
    Place at = place(node.getStartMark());
    return new Place(at.file(), at.line(), at.column(), formed.robot());
  }

  private Place place(Mark mark) {
    return new Place(file, mark.getLine() + 1, mark.getColumn() + 1);
  }
}
