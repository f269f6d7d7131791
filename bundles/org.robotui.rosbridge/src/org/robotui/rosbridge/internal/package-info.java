/** The messages of the protocol. */
package org.robotui.rosbridge.internal;
