package org.robotui.urdf.internal;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringReader;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParser;
import javax.xml.parsers.SAXParserFactory;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;

/** Reads documents that may come from anybody: no document type, thus no entities, and nothing else is ever opened. */
public final class XmlReader {
  private static final String NO_DOCTYPE = "http://apache.org/xml/features/disallow-doctype-decl";

  private XmlReader() {}

  /** Reads a text. */
  public static XmlNode read(String text, XmlLimits limits) throws Refusal {
    check(text.length(), limits);
    // a declaration of an encoding was for the bytes; blanks before it are common where a launch file wrote the text
    return read(new InputSource(new StringReader(text.strip())), leading(text), limits);
  }

  /** Reads bytes in the encoding that they declare. */
  public static XmlNode read(byte[] bytes, XmlLimits limits) throws Refusal {
    check(bytes.length, limits);
    return read(new InputSource(new ByteArrayInputStream(bytes)), 0, limits);
  }

  private static void check(long length, XmlLimits limits) throws Refusal {
    if (length > limits.characters()) {
      throw new Refusal(0,
          "the text has " + length + " characters, more than the " + limits.characters() + " that are read");
    }
  }

  private static int leading(String text) {
    int start = 0;
    int lines = 0;
    while (start < text.length() && Character.isWhitespace(text.charAt(start))) {
      lines += text.charAt(start++) == '\n' ? 1 : 0;
    }
    return lines;
  }

  private static XmlNode read(InputSource source, int linesBefore, XmlLimits limits) throws Refusal {
    XmlBuilder builder = new XmlBuilder(limits, linesBefore);
    try {
      parser().parse(source, builder);
      return builder.root().orElseThrow(() -> new Refusal(0, "the text has no element"));
    } catch (XmlBuilder.TooMuch e) {
      throw new Refusal(e.line(), e.getMessage());
    } catch (SAXParseException e) {
      throw new Refusal(Math.max(0, e.getLineNumber() + linesBefore), words(e));
    } catch (SAXException | IOException | ParserConfigurationException e) {
      throw new Refusal(0, "cannot be read as XML: " + e.getMessage());
    }
  }

  private static String words(SAXParseException e) {
    String message = String.valueOf(e.getMessage());
    return message.contains("DOCTYPE")
        ? "a <!DOCTYPE ...> is not read, as it could make the reader open other files; remove it"
        : "not well-formed XML: " + message;
  }

  private static SAXParser parser() throws ParserConfigurationException, SAXException {
    // the JDK's own: another one on the class path might not know the features
    SAXParserFactory factory = SAXParserFactory.newDefaultInstance();
    factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
    factory.setFeature(NO_DOCTYPE, true);
    factory.setFeature("http://xml.org/sax/features/external-general-entities", false);
    factory.setFeature("http://xml.org/sax/features/external-parameter-entities", false);
    factory.setXIncludeAware(false);
    return factory.newSAXParser();
  }
}
