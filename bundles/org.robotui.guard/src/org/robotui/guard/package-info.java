/**
 * Connections to robots that a small process of its own keeps. It goes on to read when this process is stopped or
 * killed, so that a robot whose software writes synchronously never waits for us, and says farewell in our place.
 */
package org.robotui.guard;
