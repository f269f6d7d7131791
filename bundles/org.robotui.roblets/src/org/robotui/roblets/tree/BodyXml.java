package org.robotui.roblets.tree;

import java.io.StringReader;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.robotui.net.log.PeerText;

/**
 * Messages as bytes, UTF-8. Read are {@value #MOST_BYTES} bytes, {@value #DEEPEST} levels, {@value #MOST_ELEMENTS}
 * elements and {@value #MOST_ATTRIBUTES} attributes of one of them at most; a document type is refused, so that there
 * are no entities but those of XML itself, and nothing else is opened.
 */
public final class BodyXml {
  /** As many bytes have a message at most: it goes in one datagram. */
  public static final int MOST_BYTES = 60_000;

  /** As many levels has a message at most. */
  public static final int DEEPEST = 32;

  /** As many elements has a message at most. */
  public static final int MOST_ELEMENTS = 4096;

  /** As many attributes has an element at most. */
  public static final int MOST_ATTRIBUTES = 128;

  private final XMLInputFactory factory;

  /** Reads and writes. */
  public BodyXml() {
    // the JDK's own: another one on the class path might not know the properties
    factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    factory.setProperty(XMLInputFactory.IS_NAMESPACE_AWARE, false);
    factory.setProperty(XMLInputFactory.IS_COALESCING, true);
    factory.setXMLReporter((message, type, about, where) -> {}); // what is wrong is thrown as well
  }

  /**
   * Reads a message.
   *
   * @param bytes of one element
   * @return the element
   * @throws BodyXmlException where it is none, or too much
   */
  public BodyElement read(byte[] bytes) throws BodyXmlException {
    if (bytes.length > MOST_BYTES) {
      throw new BodyXmlException("a message of " + bytes.length + " bytes; not more than " + MOST_BYTES + " are read");
    }
    try {
      return new Building(reader(bytes)).read();
    } catch (XMLStreamException | IllegalArgumentException e) {
      throw new BodyXmlException("no message: " + PeerText.brief(String.valueOf(e.getMessage())));
    } catch (RuntimeException e) {
      // the reader of the JDK has such for some encodings and names
      throw new BodyXmlException("no message: " + PeerText.brief(String.valueOf(e)));
    }
  }

  private synchronized XMLStreamReader reader(byte[] bytes) throws XMLStreamException {
    try {
      return factory.createXMLStreamReader(
          new StringReader(StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString()));
    } catch (CharacterCodingException e) {
      throw new XMLStreamException("it is not UTF-8", e);
    }
  }

  /** Reads one document. */
  private static final class Building {
    private final XMLStreamReader reader;
    private final Deque<Open> open = new ArrayDeque<>();
    private int elements;

    /** An element whose end was not read yet. */
    private record Open(String name, Map<String, String> attributes, StringBuilder text, List<BodyElement> children) {}

    Building(XMLStreamReader reader) {
      this.reader = reader;
    }

    BodyElement read() throws XMLStreamException, BodyXmlException {
      while (reader.hasNext()) {
        switch (reader.next()) {
          case XMLStreamConstants.START_ELEMENT -> begin();
          case XMLStreamConstants.CHARACTERS,
              XMLStreamConstants.CDATA -> open.element().text().append(reader.getText());
          case XMLStreamConstants.DTD, XMLStreamConstants.ENTITY_REFERENCE -> throw new BodyXmlException(
              "a message has no document type and no entities; leave them out");
          case XMLStreamConstants.END_ELEMENT -> {
            Open ended = open.pop();
            BodyElement element =
                new BodyElement(ended.name(), ended.attributes(), ended.text().toString(), ended.children());
            if (open.isEmpty()) {
              finish();
              return element;
            }
            open.element().children().add(element);
          }
          default -> {
            // comments and instructions say nothing
          }
        }
      }
      throw new BodyXmlException("no message: it has no element");
    }

    private void begin() throws BodyXmlException {
      if (++elements > MOST_ELEMENTS || open.size() >= DEEPEST || reader.getAttributeCount() > MOST_ATTRIBUTES) {
        throw new BodyXmlException("a message with more than " + MOST_ELEMENTS + " elements, " + DEEPEST
            + " levels or " + MOST_ATTRIBUTES + " attributes of one element is not read");
      }
      Map<String, String> attributes = new LinkedHashMap<>();
      for (int i = 0; i < reader.getAttributeCount(); i++) {
        attributes.put(reader.getAttributeLocalName(i), reader.getAttributeValue(i));
      }
      open.push(new Open(reader.getLocalName(), attributes, new StringBuilder(), new ArrayList<>()));
    }

    /** What follows the element is read as well, since it may be no XML. */
    private void finish() throws XMLStreamException {
      while (reader.hasNext()) {
        reader.next();
      }
    }
  }

  /**
   * Writes a message.
   *
   * @param element what to write
   * @return its bytes
   * @throws IllegalArgumentException where it is larger than what is read
   */
  public static byte[] bytes(BodyElement element) {
    byte[] bytes = text(element).getBytes(StandardCharsets.UTF_8);
    if (bytes.length > MOST_BYTES) {
      throw new IllegalArgumentException("'" + element.name() + "' has " + bytes.length + " bytes, more than the "
          + MOST_BYTES + " that go in one datagram; send less in one message");
    }
    return bytes;
  }

  /**
   * Writes a message on one line.
   *
   * @param element what to write
   * @return the text
   */
  public static String text(BodyElement element) {
    StringBuilder to = new StringBuilder();
    write(element, to, 0);
    return to.toString();
  }

  private static void write(BodyElement element, StringBuilder to, int depth) {
    if (depth >= DEEPEST) {
      throw new IllegalArgumentException("a message has " + DEEPEST + " levels at most");
    }
    to.append('<').append(element.name());
    element.attributes().forEach((name, value) -> {
      to.append(' ').append(name).append("=\"");
      escape(value, to);
      to.append('"');
    });
    if (element.text().isEmpty() && element.children().isEmpty()) {
      to.append("/>");
      return;
    }
    to.append('>');
    escape(element.text(), to);
    element.children().forEach(child -> write(child, to, depth + 1));
    to.append("</").append(element.name()).append('>');
  }

  /** What XML cannot hold at all becomes a question mark. */
  private static void escape(String text, StringBuilder to) {
    text.codePoints().forEach(c -> {
      switch (c) {
        case '&' -> to.append("&amp;");
        case '<' -> to.append("&lt;");
        case '>' -> to.append("&gt;");
        case '"' -> to.append("&quot;");
        case '\n', '\r', '\t' -> to.append("&#").append(c).append(';');
        default -> {
          boolean fine = c >= ' ' && !(c >= 0xd800 && c <= 0xdfff) && c != 0xfffe && c != 0xffff;
          to.appendCodePoint(fine ? c : '?');
        }
      }
    });
  }
}
