package elsewhere;

/** Of another package than those who inherit from it. */
public class Base {
  protected String inherited(String word) {
    return "inherited " + word;
  }

  public String open(String word) {
    return "open " + word;
  }
}
