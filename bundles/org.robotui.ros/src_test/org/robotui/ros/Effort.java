package org.robotui.ros;

/** How hard tests with random input try: {@code ./robotui test --long} asks for more. */
public final class Effort {
    private static final int LONG = 50;

    private Effort() {
    }

    /** Rounds, so many in everyday runs and fifty times as many in long ones. */
    public static int rounds(int everyday) {
        return "1".equals(System.getenv("ROBOTUI_LONG")) ? everyday * LONG : everyday;
    }
}
