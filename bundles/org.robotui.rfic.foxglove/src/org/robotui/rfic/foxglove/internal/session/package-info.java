/** One connection to a server, and the topics behind it. */
package org.robotui.rfic.foxglove.internal.session;
