package org.robotui.core.internal.compose;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.robotui.core.internal.compose.MarkedText.Span;
import org.yaml.snakeyaml.DumperOptions.FlowStyle;
import org.yaml.snakeyaml.nodes.CollectionNode;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;
import org.yaml.snakeyaml.nodes.SequenceNode;

/**
 * The items of a list or a section as parts of a text: each with the comments in the lines above it and at its end,
 * which go where it goes. Comments above the first one are of the whole.
 *
 * @param marked the text
 * @param whole the list or the section, which has items
 * @param spans of the items, in their order
 */
record ItemSpans(MarkedText marked, CollectionNode<?> whole, List<Span> spans) {
  static ItemSpans of(MarkedText marked, CollectionNode<?> whole) throws PathEdit.Refusal {
    boolean block = whole.getFlowStyle() == FlowStyle.BLOCK;
    if (!block && !marked.comments(new Span(marked.begin(whole), marked.end(whole))).isEmpty()) {
      throw new PathEdit.Refusal(marked.line(whole), "there are comments within its braces; change it with an editor");
    }
    List<Span> spans = new ArrayList<>();
    for (Object item : whole.getValue()) {
      Span bare = bare(marked, item, block);
      spans.add(!block ? bare
          : new Span(spans.isEmpty() ? bare.from() : withComments(marked, bare.from(), spans.getLast().to()),
              marked.lineEnd(bare.to())));
    }
    return new ItemSpans(marked, whole, List.copyOf(spans));
  }

  private static Span bare(MarkedText marked, Object item, boolean block) {
    if (item instanceof NodeTuple entry) {
      return new Span(marked.begin(entry.getKeyNode()), marked.end(entry));
    }
    Node node = (Node) item;
    return new Span(block ? marked.text().lastIndexOf('-', marked.begin(node) - 1) : marked.begin(node),
        marked.end(node));
  }

  /** Where the comments begin whose lines end right above. */
  private static int withComments(MarkedText marked, int begin, int after) {
    int from = begin;
    for (int line = marked.lineBegin(begin); line > after + 1;) {
      line = marked.lineBegin(line - 1);
      String words = marked.text().substring(line, marked.lineEnd(line));
      if (line <= after || !words.strip().startsWith("#")) {
        return from;
      }
      from = line + words.indexOf('#');
    }
    return from;
  }

  /** The text with the items in another order, each by its present place. */
  String arranged(List<Integer> order) {
    StringBuilder out = new StringBuilder(marked.text().substring(0, spans.getFirst().from()));
    for (int i = 0; i < order.size(); i++) {
      out.append(words(spans.get(order.get(i))));
      int next = i + 1 < spans.size() ? spans.get(i + 1).from() : marked.text().length();
      out.append(marked.text(), spans.get(i).to(), next);
    }
    return out.toString();
  }

  /** The text without an item; its comments stay where it was. */
  String without(int index) {
    Span own = spans.get(index);
    String comments = marked.comments(own).stream().collect(Collectors.joining(lineBreak()));
    TextPatch patch = new TextPatch(marked);
    if (!comments.isEmpty()) {
      return patch.replace(own, comments);
    }
    return index + 1 < spans.size() ? patch.replace(new Span(own.from(), spans.get(index + 1).from()), "")
        : index > 0 ? patch.replace(new Span(spans.get(index - 1).to(), own.to()), "")
            : patch.replace(own, whole instanceof SequenceNode ? "[]" : "{}");
  }

  /** The text with one more item of a list at its end. */
  String with(String word) {
    int end = spans.getLast().to();
    String words = whole.getFlowStyle() == FlowStyle.BLOCK ? lineBreak() + "- " + word
        : ", " + word;
    return new TextPatch(marked).replace(new Span(end, end), words);
  }

  /** The text with another name for an entry of a section. */
  String named(int index, String name) {
    Node key = ((MappingNode) whole).getValue().get(index).getKeyNode();
    return new TextPatch(marked).replace(new Span(marked.begin(key), marked.end(key)), YamlWords.text(name));
  }

  /** To below the first item of a block. */
  private String lineBreak() {
    int from = spans.getFirst().from();
    return marked.lineBreak() + " ".repeat(from - marked.lineBegin(from));
  }

  private String words(Span span) {
    return marked.text().substring(span.from(), span.to());
  }
}
