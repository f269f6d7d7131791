/** How topics become ports. */
package org.robotui.message.topic.internal;
