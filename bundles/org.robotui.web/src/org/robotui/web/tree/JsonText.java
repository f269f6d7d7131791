package org.robotui.web.tree;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import java.io.IOException;
import java.io.StringWriter;
import java.util.Map;
import java.util.Optional;

/** Reads and writes JSON. Also {@code NaN} and {@code Infinity} are read, as Python writes them. */
public final class JsonText {

  private static final int LONGEST_TEXT = 1 << 26;
  private static final int LONGEST_NAME = 10_000;
  private static final int MAX_TOP = 100;
  private static final JsonFactory FACTORY = JsonFactory.builder()
      .streamReadConstraints(StreamReadConstraints.builder().maxNestingDepth(TreeBudget.MAX_DEPTH)
          .maxStringLength(LONGEST_TEXT).maxNameLength(LONGEST_NAME).maxNumberLength(400).build())
      .disable(JsonFactory.Feature.INTERN_FIELD_NAMES).disable(JsonFactory.Feature.CANONICALIZE_FIELD_NAMES)
      .disable(StreamReadFeature.INCLUDE_SOURCE_IN_LOCATION)
      .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS).build();

  private JsonText() {}

  /**
   * Reads a whole document.
   *
   * @param text the document
   * @return the tree
   * @throws TreeException if it is none, or nested too deeply, or holds too much
   */
  public static Object read(String text) throws TreeException {
    try (JsonParser parser = FACTORY.createParser(text)) {
      return whole(parser);
    } catch (IOException e) {
      throw said(e);
    }
  }

  /**
   * Reads a whole document of UTF-8.
   *
   * @param bytes the document
   * @return the tree
   * @throws TreeException if it is none, or nested too deeply, or holds too much
   */
  public static Object read(byte[] bytes) throws TreeException {
    try (JsonParser parser = FACTORY.createParser(bytes)) {
      return whole(parser);
    } catch (IOException e) {
      throw said(e);
    }
  }

  private static Object whole(JsonParser parser) throws IOException {
    parser.nextToken();
    Object tree = new JsonTree(parser).value(0);
    if (parser.nextToken() != null) {
      throw new TreeException("something follows after the end");
    }
    return tree;
  }

  /**
   * Looks for texts of the outermost object, without reading more of it than needed: a peer that floods is sorted out
   * by them.
   *
   * @param text a document
   * @param first the name of the first
   * @param second the name of the second
   * @return both texts, empty where there is none; nothing where it is no object
   */
  public static Optional<Map.Entry<String, String>> peek(String text, String first, String second) {
    try (JsonParser parser = FACTORY.createParser(text)) {
      return parser.nextToken() == JsonToken.START_OBJECT ? Optional.of(peek(parser, first, second)) : Optional.empty();
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  private static Map.Entry<String, String> peek(JsonParser parser, String first, String second) throws IOException {
    String a = "";
    String b = "";
    for (int i = 0; i < MAX_TOP && (a.isEmpty() || b.isEmpty())
        && parser.nextToken() == JsonToken.FIELD_NAME; i++) {
      String name = parser.currentName();
      if (parser.nextToken() == JsonToken.VALUE_STRING && name.equals(first)) {
        a = parser.getText();
      } else if (parser.currentToken() == JsonToken.VALUE_STRING && name.equals(second)) {
        b = parser.getText();
      } else {
        parser.skipChildren();
      }
    }
    return Map.entry(a, b);
  }

  /**
   * Writes a document.
   *
   * @param tree of the values that are read, and lists, arrays and numbers of any kind; numbers that JSON has not, such
   * as NaN, become null
   * @return the document
   */
  public static String write(Object tree) {
    StringWriter text = new StringWriter();
    try (JsonGenerator out = FACTORY.createGenerator(text)) {
      new JsonWriter(out).value(tree);
    } catch (IOException e) {
      throw new IllegalStateException("a text takes all that is written", e);
    }
    return text.toString();
  }

  /** Without the place in the source, which Jackson appends in a line of its own. */
  private static TreeException said(IOException error) {
    return error instanceof TreeException own ? own
        : new TreeException("no JSON: " + String.valueOf(error.getMessage()).lines().findFirst().orElse(""));
  }
}
