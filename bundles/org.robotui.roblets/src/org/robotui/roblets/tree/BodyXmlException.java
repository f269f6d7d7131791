package org.robotui.roblets.tree;

/** What came is no message: it is no XML, has a document type, or is larger or deeper than what is read. */
public final class BodyXmlException extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * With a reason.
   *
   * @param reason a sentence for users
   */
  public BodyXmlException(String reason) {
    super(reason);
  }
}
