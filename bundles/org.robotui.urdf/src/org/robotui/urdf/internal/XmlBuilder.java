package org.robotui.urdf.internal;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;

/** Makes nodes of what the parser tells, and stops where it is too much. */
final class XmlBuilder extends DefaultHandler {
  private final XmlLimits limits;
  private final int linesBefore;
  private final Deque<Open> open = new ArrayDeque<>();
  private Optional<Locator> locator = Optional.empty();
  private Optional<XmlNode> root = Optional.empty();
  private int elements;

  XmlBuilder(XmlLimits limits, int linesBefore) {
    this.limits = limits;
    this.linesBefore = linesBefore;
  }

  Optional<XmlNode> root() {
    return root;
  }

  @Override
  public void setDocumentLocator(Locator places) {
    locator = Optional.of(places);
  }

  @Override
  public void startElement(String uri, String localName, String name, Attributes attributes) throws SAXException {
    if (open.size() >= limits.depth()) {
      throw new TooMuch(line(), "elements lie more than " + limits.depth() + " deep in each other");
    }
    if (++elements > limits.elements()) {
      throw new TooMuch(line(), "more than " + limits.elements() + " elements");
    }
    XmlNode node = new XmlNode(name, values(attributes), line());
    if (open.isEmpty()) {
      root = Optional.of(node);
    } else {
      open.peek().node.add(node);
    }
    open.push(new Open(node, new StringBuilder(0)));
  }

  @Override
  public void characters(char[] characters, int start, int length) {
    open.peek().text.append(characters, start, length);
  }

  @Override
  public void endElement(String uri, String localName, String name) {
    Open done = open.pop();
    done.node.text(done.text.toString().strip());
  }

  @Override
  public InputSource resolveEntity(String publicId, String systemId) throws SAXException {
    throw new TooMuch(line(), "names another file '" + systemId + "', which is not read");
  }

  @Override
  public void fatalError(SAXParseException e) throws SAXException {
    throw e;
  }

  private int line() {
    return locator.map(l -> l.getLineNumber() + linesBefore).orElse(0);
  }

  private static Map<String, String> values(Attributes attributes) {
    Map<String, String> values = HashMap.newHashMap(attributes.getLength());
    for (int i = 0; i < attributes.getLength(); i++) {
      values.put(attributes.getQName(i), attributes.getValue(i));
    }
    return values;
  }

  private record Open(XmlNode node, StringBuilder text) {}

  /** A document is larger than allowed. */
  static final class TooMuch extends SAXException {
    private static final long serialVersionUID = 1;

    private final int line;

    TooMuch(int line, String why) {
      super(why);
      this.line = line;
    }

    int line() {
      return line;
    }
  }
}
